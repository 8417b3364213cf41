//! Formats of table files: CSV, and with the feature `tables` also the column formats Parquet and Arrow.
//!
//! Every table is first written as CSV, under a temporary name, so that an interrupted command can continue it. A table
//! in a column format is converted from the CSV table at the end.

use crate::terminal::failure::Failure;
use std::path::Path;
use tripos_codegen::draft_file::Draft;
use tripos_derive::plain_text::path_as_plain_text;

/// Format of a table file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFormat {
    /// Lines of text with commas between the values.
    Csv,
    /// Apache Parquet: compressed columns.
    #[cfg(feature = "tables")]
    Parquet,
    /// Apache Arrow's file format (IPC), which is also called Feather.
    #[cfg(feature = "tables")]
    Arrow,
}

/// File name extensions of other formats for tables, which no command writes.
const OTHER_FORMATS: [&str; 8] = ["xlsx", "xls", "ods", "mat", "h5", "hdf5", "npy", "npz"];

impl TableFormat {
    /// Selects the format by the ending of a file name; CSV for any unknown ending.
    ///
    /// # Errors
    /// [`Failure`] for the ending of a table format that this program does not write.
    pub fn of_name(path: &Path) -> Result<Self, Failure> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        match ending.as_str() {
            #[cfg(feature = "tables")]
            "parquet" => Ok(Self::Parquet),
            #[cfg(feature = "tables")]
            "arrow" | "feather" => Ok(Self::Arrow),
            #[cfg(not(feature = "tables"))]
            "parquet" | "arrow" | "feather" => {
                let what = format!("`{}` is a table in columns, and this program writes CSV", path_as_plain_text(path));
                let help = "build it with `--features tripos-cli/tables`, or give a file that ends in .csv";
                Err(Failure::request(what, help))
            }
            other if OTHER_FORMATS.contains(&other) => {
                let what = format!("`{}` ends in `.{ending}`, and this command writes CSV", path_as_plain_text(path));
                Err(Failure::request(what, "give a file that ends in .csv, which other programs convert"))
            }
            _ => Ok(Self::Csv),
        }
    }

    /// Finishes a file, whose draft is a CSV table, in this format.
    ///
    /// # Errors
    /// [`Failure`] if the file cannot be written or renamed.
    pub fn finish(self, draft: Draft) -> Result<(), Failure> {
        match self {
            Self::Csv => Ok(draft.finish()?),
            #[cfg(feature = "tables")]
            Self::Parquet => Ok(draft.finish_converted(columns::write_parquet)?),
            #[cfg(feature = "tables")]
            Self::Arrow => Ok(draft.finish_converted(columns::write_arrow)?),
        }
    }
}

/// Conversion of CSV tables to column formats.
#[cfg(feature = "tables")]
mod columns {
    use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
    use arrow_schema::{ArrowError, DataType, Field, Schema};
    use std::io;
    use std::io::{Read, Write};
    use std::sync::Arc;

    /// Number of rows that are converted together.
    const ROWS: usize = 1 << 16;

    /// Converts a CSV table to a Parquet file.
    pub fn write_parquet(csv: &mut impl Read, out: impl Write + Send) -> io::Result<()> {
        let mut table = ColumnReader::new(csv)?;
        let compressed = parquet::basic::Compression::SNAPPY;
        let properties = parquet::file::properties::WriterProperties::builder().set_compression(compressed).build();
        let mut writer = parquet::arrow::ArrowWriter::try_new(out, Arc::clone(&table.schema), Some(properties))
            .map_err(io::Error::other)?;
        while let Some(batch) = table.next_batch()? {
            writer.write(&batch).map_err(io::Error::other)?;
        }
        writer.into_inner().map_err(io::Error::other)?.flush()
    }

    /// Converts a CSV table to an Arrow file.
    pub fn write_arrow(csv: &mut impl Read, out: impl Write) -> io::Result<()> {
        let mut table = ColumnReader::new(csv)?;
        let mut writer = arrow_ipc::writer::FileWriter::try_new(out, &table.schema).map_err(io::Error::other)?;
        while let Some(batch) = table.next_batch()? {
            writer.write(&batch).map_err(io::Error::other)?;
        }
        writer.into_inner().map_err(io::Error::other)?.flush()
    }

    /// Type of a column: texts, numbers of points, or numbers that may be missing. The columns `stop`, `reason` and
    /// `index` have fixed types, because they may be empty in the first rows of a part of a sweep. The first rows
    /// decide the types of other columns.
    fn column_type(name: &str, mut cells: impl Iterator<Item = impl AsRef<str>>) -> DataType {
        match name {
            "stop" | "warning" | "reason" => DataType::Utf8,
            "index" => DataType::Int64,
            _ if cells.all(|cell| cell.as_ref().is_empty() || cell.as_ref().parse::<f64>().is_ok()) => {
                DataType::Float64
            }
            _ => DataType::Utf8,
        }
    }

    /// Reader of a CSV table that returns batches of columns.
    struct ColumnReader<'a, R> {
        /// Names and types of the columns.
        schema: Arc<Schema>,
        /// Reader of the rows after the first rows.
        rows: csv::Reader<&'a mut R>,
        /// First rows, which were read to determine the types of the columns.
        first: Vec<csv::StringRecord>,
    }

    impl<'a, R: Read> ColumnReader<'a, R> {
        /// Reads the header and the first rows of a table.
        fn new(csv: &'a mut R) -> io::Result<Self> {
            let mut rows = csv::Reader::from_reader(csv);
            let names = rows.headers()?.clone();
            let first = next_rows(&mut rows)?;
            let field = |(at, name): (usize, &str)| {
                let of = column_type(name, first.iter().map(|row| &row[at]));
                let may_be_missing = of == DataType::Float64;
                Field::new(name, of, may_be_missing)
            };
            let schema = Schema::new(names.iter().enumerate().map(field).collect::<Vec<_>>());
            Ok(Self { schema: Arc::new(schema), rows, first })
        }

        /// Reads the next rows as columns; `None` at the end of the table.
        fn next_batch(&mut self) -> io::Result<Option<RecordBatch>> {
            let first = std::mem::take(&mut self.first);
            let rows = if first.is_empty() { next_rows(&mut self.rows)? } else { first };
            if rows.is_empty() {
                return Ok(None);
            }
            let fields = self.schema.fields().iter().enumerate();
            let columns = fields.map(|(at, field)| column(field.data_type(), rows.iter().map(|row| &row[at])));
            let columns = columns.collect::<Result<Vec<ArrayRef>, ArrowError>>().map_err(io::Error::other)?;
            RecordBatch::try_new(Arc::clone(&self.schema), columns).map(Some).map_err(io::Error::other)
        }
    }

    /// Reads the next rows of a table, at most [`ROWS`].
    fn next_rows(rows: &mut csv::Reader<impl Read>) -> io::Result<Vec<csv::StringRecord>> {
        Ok(rows.records().take(ROWS).collect::<Result<_, _>>()?)
    }

    /// Creates a column of a type from the texts of its cells. An empty cell is a missing number.
    fn column<'c>(of: &DataType, cells: impl Iterator<Item = &'c str>) -> Result<ArrayRef, ArrowError> {
        let wrong = |cell: &str| ArrowError::ParseError(format!("`{cell}` is no number"));
        Ok(match of {
            DataType::Utf8 => Arc::new(StringArray::from_iter_values(cells)),
            DataType::Int64 => {
                let numbers = cells.map(|cell| cell.parse::<i64>().map_err(|_| wrong(cell)));
                Arc::new(Int64Array::from_iter_values(numbers.collect::<Result<Vec<_>, _>>()?))
            }
            _ => {
                let number = |cell: &str| cell.parse::<f64>().map(Some).map_err(|_| wrong(cell));
                let numbers = cells.map(|cell| if cell.is_empty() { Ok(None) } else { number(cell) });
                Arc::new(numbers.collect::<Result<Float64Array, _>>()?)
            }
        })
    }
}

//! Meshes of robot descriptions as boxes at their bounds: `tripos new --from`.

use crate::robots::model_in;

/// Vertices of a tetrahedron, m, that touches each side of its bounds.
const VERTICES: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [0.5, 0.125, 0.0], [0.125, 0.75, 0.0625], [0.0625, 0.125, 0.25]];
/// Indices of the vertices of each face.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// Shape of the model for this mesh at the origin of its link.
const BOX: &str = "kind = \"box\", size = [\"0.5 m\", \"0.75 m\", \"0.25 m\"], frame = \"arm_frame\", at = \"j\", \
    position = [\"0.25 m\", \"0.375 m\", \"0.125 m\"] } # Bounds of the mesh";

/// Binary STL file of triangles, with a stated number of them. Its comment begins as text files do.
fn binary_stl(triangles: &[[[f32; 3]; 3]], count: u32) -> Vec<u8> {
    let mut bytes = b"solid in binary form".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flatten().flat_map(|number| number.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// Triangles of the tetrahedron.
fn triangles() -> [[[f32; 3]; 3]; 4] {
    FACES.map(|face| face.map(|vertex| VERTICES[vertex]))
}

/// Text STL file of the tetrahedron.
fn text_stl() -> String {
    let vertex = |[x, y, z]: [f32; 3]| format!("      vertex {x:e} {y} {z}\r\n");
    let facet = |triangle: [[f32; 3]; 3]| {
        format!("  facet normal 0 0 0\n    outer loop\n{}    endloop\n  endfacet\n", triangle.map(vertex).concat())
    };
    format!("solid tetrahedron\n{}endsolid\n", triangles().map(facet).concat())
}

/// OBJ file of the tetrahedron.
fn obj() -> String {
    let vertices = VERTICES.map(|[x, y, z]| format!("v {x} {y} {z}\n")).concat();
    let faces = FACES.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1)).concat();
    format!("# A tetrahedron.\nmtllib absent.mtl\n{vertices}vn 9 9 9\nvt 9 9\n{faces}")
}

/// URDF file of a moving link with a mesh.
fn urdf(name: &str, scale: &str) -> String {
    format!(
        r#"<robot name="arm"><link name="base"/><link name="arm">
        <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
        <visual><geometry><mesh filename="{name}"{scale}/></geometry></visual></link>
        <joint name="j" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>"#
    )
}

/// MJCF file of a moving body with a mesh.
fn mjcf(compiler: &str, asset: &str, geom: &str) -> String {
    format!(
        r#"<mujoco><compiler {compiler}/><asset>{asset}</asset><worldbody><body name="arm"><joint name="j"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/><geom {geom}/></body></worldbody></mujoco>"#
    )
}

/// Model of a description in a folder of its own with one more file; the model compiles.
fn model_with(description: &str, text: &str, file: &str, content: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("robot_description").join(file);
    std::fs::create_dir_all(place.parent().unwrap()).unwrap();
    std::fs::write(place, content).unwrap();
    std::fs::create_dir_all(folder.path().join("robot_description/urdf")).unwrap();
    let model = model_in(&folder.path().join("robot_description/urdf"), description, text, &[]);
    let path = folder.path().join("robot_description/urdf");
    let (status, out, err) = crate::support::tripos_in(&path, &["check", "robot/model.toml"]);
    assert_eq!(status, 0, "{out}{err}");
    model
}

/// Goal: a mesh is drawn as the box at its bounds, whatever the form of its file and the form of its name. Method: a
/// tetrahedron of known size.
#[test]
fn meshes_become_boxes_at_their_bounds() {
    let binary = binary_stl(&triangles(), 4);
    for (file, content, name) in [
        ("meshes/arm.stl", binary.as_slice(), "package://robot_description/meshes/arm.stl"),
        ("meshes/arm.STL", text_stl().as_bytes(), "model://robot_description/meshes/arm.STL"),
        ("meshes/arm.obj", obj().as_bytes(), "../meshes/arm.obj"),
        ("urdf/arm.obj", obj().as_bytes(), "arm.obj"),
    ] {
        let model = model_with("arm.urdf", &urdf(name, ""), file, content);
        assert!(model.contains(&format!("{BOX} {name}\n")), "{name}: {model}");
        assert!(model.contains("# Left out: form of a mesh: it is drawn as the box at its bounds."), "{model}");
    }
    let model =
        model_with("arm.urdf", &urdf("../arm.obj", " scale=\"-0.002 0.001 0.001\""), "arm.obj", obj().as_bytes());
    let scaled = "size = [\"0.001 m\", \"0.00075 m\", \"0.00025 m\"], frame = \"arm_frame\", at = \"j\", \
        position = [\"-0.0005 m\", \"0.000375 m\", \"0.000125 m\"]";
    assert!(model.contains(scaled), "{model}");
    for (compiler, asset, geom) in [
        ("meshdir=\"../meshes\"", "<mesh name=\"a\" file=\"arm.stl\"/>", "type=\"mesh\" mesh=\"a\""),
        ("assetdir=\"..\"", "<mesh file=\"meshes/arm.stl\"/>", "type=\"mesh\" mesh=\"arm\""),
        ("meshdir=\"../meshes\" strippath=\"true\"", "<mesh file=\"far/arm.stl\"/>", "mesh=\"arm\""),
    ] {
        let model = model_with("arm.xml", &mjcf(compiler, asset, geom), "meshes/arm.stl", &binary);
        assert!(model.contains(BOX), "{compiler}: {model}");
    }
}

/// Goal: scale, reference position and reference quaternion of MJCF act as in MuJoCo. Method: the bounds that MuJoCo
/// 4.0 computes of the vertices that it compiled, in the axes of the geom: from (−0.2, −0.157894737, −0.15) to
/// (0.524210526, 0.331578947, −0.007894737).
#[test]
fn meshes_of_mjcf_are_scaled_moved_and_turned() {
    let vertices = "vertex=\"0 0 0  0.4 0.1 0  0.1 0.5 0.05  0.05 0.1 0.3\"";
    let frame = "scale=\"2 -1 0.5\" refpos=\"0.1 0.2 0.3\" refquat=\"0.9 0.1 0.2 0.3\"";
    let asset = format!("<mesh name=\"a\" {vertices} {frame}/>");
    let text = mjcf("", &asset, "type=\"mesh\" mesh=\"a\" pos=\"1 2 3\"");
    let folder = tempfile::tempdir().unwrap();
    let model = model_in(folder.path(), "arm.xml", &text, &[]);
    let line = model.lines().find(|line| line.contains("kind = \"box\"")).unwrap();
    let numbers: Vec<f64> = line.split('"').filter_map(|part| part.strip_suffix(" m")?.parse().ok()).collect();
    let wanted = [0.724_210_526, 0.489_473_684, 0.142_105_263, 1.162_105_263, 2.086_842_105, 2.921_052_632];
    assert_eq!(numbers.len(), wanted.len(), "{line}");
    for (own, wanted) in numbers.iter().zip(wanted) {
        assert!((own - wanted).abs() < 1e-8, "{line}");
    }
}

/// Goal: no mesh stops an import, and each that is left out is listed with the reason. Method: files that are absent,
/// empty, cut off, of another kind, or have wrong numbers.
#[test]
fn meshes_that_cannot_be_read_are_listed_with_the_reason() {
    let flat = [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]];
    let nan = [[[0.0, 0.0, 0.0], [f32::NAN, 0.0, 0.0], [0.0, 1.0, 0.0]]];
    let point = [[[1.0; 3]; 3]];
    let cut = "the file is cut off: its last line is not `endsolid`";
    let text = text_stl();
    let in_a_number = text.rfind("0.25").map_or(0, |at| at + 2);
    let neither = "the file is neither STL in text form nor as long as its number of triangles";
    for (file, content, reason) in [
        ("a.dae", &b"<COLLADA/>"[..], "only STL and OBJ files are read"),
        ("a", b"v 0 0 0", "only STL and OBJ files are read"),
        ("b.stl", b"", neither),
        ("c.stl", &binary_stl(&triangles(), 4)[..150], neither),
        ("d.stl", &binary_stl(&flat, u32::MAX), neither),
        ("e.stl", &[&[0; 80][..], &[0xff; 4], &[0; 50]].concat(), neither),
        ("f.stl", &binary_stl(&[], 0), "it has no vertex"),
        ("g.stl", &binary_stl(&nan, 1), "a coordinate of a vertex is not finite"),
        ("h.stl", &binary_stl(&point, 1), "it is a point"),
        ("i.stl", b"solid\nfacet\nvertex 1 2\n", "a vertex has no three numbers"),
        ("j.stl", b"solid\nfacet\nvertex 1 2 inf\n", "a coordinate of a vertex is not finite"),
        ("o.stl", text.split_inclusive("endfacet\n").next().unwrap().as_bytes(), cut),
        ("p.stl", &text.as_bytes()[..in_a_number], cut),
        ("q.stl", text.trim_end().trim_end_matches("endsolid").as_bytes(), cut),
        ("k.obj", b"", "it has no vertex"),
        ("l.obj", b"v 1 2 x\n", "a vertex has no three numbers"),
        ("m.obj", b"v -1e308 0 0\nv 1e308 0 0\n", "its size is not finite"),
        ("n.obj", &[0xff; 300], "it has no vertex"),
    ] {
        let model = model_with("arm.urdf", &urdf(&format!("../{file}"), ""), file, content);
        assert!(model.contains(&format!("# Left out: mesh ../{file}: {reason}.")), "{file}: {model}");
        assert!(!model.contains("kind = \"box\""), "{file}: {model}");
    }
    let flat = model_with("arm.urdf", &urdf("../a.stl", ""), "a.stl", &binary_stl(&flat, 1));
    assert!(flat.contains("size = [\"1 m\", \"1 m\", \"0.001 m\"]"), "{flat}");
    let obj = obj();
    let cases = [
        (urdf("../b.obj", ""), "mesh ../b.obj: there is no such file"),
        (urdf("package://elsewhere/a.obj", ""), "mesh package://elsewhere/a.obj: there is no such file"),
        (urdf("../a.obj", " scale=\"1 1\""), "mesh ../a.obj: its `scale` is not three numbers"),
        (urdf("../a.obj", " scale=\"nan 1 1\""), "mesh ../a.obj: a coordinate of a vertex is not finite"),
        (urdf("../a.obj", " scale=\"0 0 0\""), "mesh ../a.obj: it is a point"),
    ];
    for (text, reason) in cases {
        let model = model_with("arm.urdf", &text, "a.obj", obj.as_bytes());
        assert!(model.contains(&format!("# Left out: {reason}.")), "{reason}: {model}");
    }
    let mesh = "type=\"mesh\" mesh=\"a\"";
    for (asset, geom, reason) in [
        ("", mesh, "mesh a: the file has no such mesh"),
        ("<mesh name=\"a\"/>", mesh, "mesh a: it has no file and no vertices"),
        ("<mesh name=\"a\" file=\"../b.stl\"/>", mesh, "mesh a: there is no such file"),
        ("<mesh name=\"a\" file=\"../a.obj\" scale=\"1\"/>", mesh, "mesh a: its `scale` is not 3 finite numbers"),
        ("<mesh name=\"a\" file=\"../a.obj\" refquat=\"0 0 0 0\"/>", mesh, "mesh a: its `refquat` is 0"),
        ("<mesh name=\"a\" vertex=\"0 0 0 1\"/>", mesh, "mesh a: a vertex has no three numbers"),
        ("<mesh name=\"a\" vertex=\"0 0 nan\"/>", mesh, "mesh a: a coordinate of a vertex is no finite number"),
        (
            "<mesh name=\"a\" file=\"../a.obj\"/>",
            "type=\"box\" mesh=\"a\"",
            "mesh a: a box that MuJoCo fits to it is not read",
        ),
    ] {
        let model = model_with("arm.xml", &mjcf("", asset, geom), "a.obj", obj.as_bytes());
        assert!(model.contains(&format!("# Left out: {reason}.")), "{reason}: {model}");
    }
}

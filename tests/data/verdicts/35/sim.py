import numpy as np
def rhs(t, z):
    omega, theta = z
    acc = -X*w**2*np.cos(w*t)
    alpha = (-g*np.sin(theta) - acc*np.cos(theta))/l - c*omega/(m*l**2)
    return np.array([omega, alpha])

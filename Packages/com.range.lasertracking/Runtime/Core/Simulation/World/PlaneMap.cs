using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>A projective mapping of the plane without allocation: (A x + B y + C, D x + E y + F) / (G x + H y + I).</summary>
    internal readonly struct PlaneMap
    {
        public readonly double A, B, C, D, E, F, G, H, I;

        public PlaneMap(double a, double b, double c, double d, double e, double f, double g, double h, double i)
        {
            A = a;
            B = b;
            C = c;
            D = d;
            E = e;
            F = f;
            G = g;
            H = h;
            I = i;
        }

        public PlaneMap Inverse => new PlaneMap(
            E * I - F * H, C * H - B * I, B * F - C * E,
            F * G - D * I, A * I - C * G, C * D - A * F,
            D * H - E * G, B * G - A * H, A * E - B * D);

        public static PlaneMap Scale(double x, double y, double offsetX, double offsetY) =>
            new PlaneMap(x, 0, offsetX, 0, y, offsetY, 0, 0, 1);

        /// <summary>first, then second.</summary>
        public static PlaneMap operator *(in PlaneMap second, in PlaneMap first)
        {
            PlaneMap p = second, q = first;
            return new PlaneMap(
                p.A * q.A + p.B * q.D + p.C * q.G, p.A * q.B + p.B * q.E + p.C * q.H, p.A * q.C + p.B * q.F + p.C * q.I,
                p.D * q.A + p.E * q.D + p.F * q.G, p.D * q.B + p.E * q.E + p.F * q.H, p.D * q.C + p.E * q.F + p.F * q.I,
                p.G * q.A + p.H * q.D + p.I * q.G, p.G * q.B + p.H * q.E + p.I * q.H, p.G * q.C + p.H * q.F + p.I * q.I);
        }

        public Vector2D Map(Vector2D p)
        {
            double w = G * p.X + H * p.Y + I;
            return new Vector2D((A * p.X + B * p.Y + C) / w, (D * p.X + E * p.Y + F) / w);
        }

        /// <summary>Partial derivatives at a point: dx' = xx dx + xy dy, dy' = yx dx + yy dy.</summary>
        public void Jacobian(Vector2D p, out double xx, out double xy, out double yx, out double yy)
        {
            double w = G * p.X + H * p.Y + I;
            Vector2D image = Map(p);
            xx = (A - image.X * G) / w;
            xy = (B - image.X * H) / w;
            yx = (D - image.Y * G) / w;
            yy = (E - image.Y * H) / w;
        }

        public double[] ToArray() => new[] { A, B, C, D, E, F, G, H, I };
    }
}

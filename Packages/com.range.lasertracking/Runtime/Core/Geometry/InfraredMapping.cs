using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Where in the colour picture lies what the infrared picture shows, for things on the screen. Both lenses are corrected first
    /// where they are known; what remains between two views of a plane is a homography. Immutable, allocates nothing when it maps.
    /// </summary>
    public sealed class InfraredMapping
    {
        private const double SigmaWidthPx = 1920;

        // How well points are marked by eye; with many points their own scatter tells.
        private const double MarkedPx = 0.5;

        private readonly LensCamera? _infrared;
        private readonly LensCamera? _color;
        private readonly Homography _homography;

        private InfraredMapping(LensCamera? infrared, Homography homography, LensCamera? color, double sigmaPx)
        {
            _infrared = infrared;
            _homography = homography;
            _color = color;
            SigmaPx = sigmaPx;
        }

        /// <summary>How far off it may be, one standard deviation along each axis, colour px of a picture 1920 wide.</summary>
        public double SigmaPx { get; }

        /// <summary>From infrared to colour: between rays normalised to z = 1 where the lenses are known, else between pixels.</summary>
        public Homography RayHomography => _homography;

        /// <summary>Size of the pictures that it was calibrated for; true for any when it knows none.</summary>
        public bool IsFor(int infraredWidth, int infraredHeight, int colorWidth, int colorHeight) => IsOf(_infrared, infraredWidth, infraredHeight) && IsOf(_color, colorWidth, colorHeight);

        /// <summary>
        /// Nothing is known: both pictures are taken to show the same field of view, edge to edge, as the published module does. Off by
        /// as much as the cameras differ.
        /// </summary>
        public static InfraredMapping EqualFields(int infraredWidth, int infraredHeight, int colorWidth, int colorHeight)
        {
            double x = (double)colorWidth / infraredWidth, y = (double)colorHeight / infraredHeight;
            return new InfraredMapping(null, new Homography(new[] { x, 0, 0.5 * x - 0.5, 0, y, 0.5 * y - 0.5, 0, 0, 1 }), null, 6);
        }

        /// <summary>Points on the screen were marked in both pictures; the lenses stay uncorrected.</summary>
        public static InfraredMapping OfPlane(Homography infraredPxToColorPx) => new InfraredMapping(null, infraredPxToColorPx, null, 2);

        /// <summary>Both lenses are known, and at least four points of the screen were marked in both pictures.</summary>
        /// <param name="infrared">The infrared camera.</param>
        /// <param name="color">The colour camera.</param>
        /// <param name="infraredPx">Points of the screen, pixels of the infrared picture.</param>
        /// <param name="colorPx">The same points, pixels of the colour picture.</param>
        /// <param name="mapping">Null when refused.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryFitPlane(LensCamera infrared, LensCamera color, ReadOnlySpan<Vector2D> infraredPx, ReadOnlySpan<Vector2D> colorPx, out InfraredMapping? mapping, out string reason)
        {
            mapping = null;
            if (!TryUnproject(infrared, infraredPx, out Vector2D[] infraredRays, out reason) || !TryUnproject(color, colorPx, out Vector2D[] colorRays, out reason)
                || !HomographyFit.TryFit(infraredRays, colorRays, MarkedPx / color.Pinhole.FocalXPx, out HomographyFit? rays, out reason))
                return false;
            mapping = new InfraredMapping(infrared, rays!.Homography, color, rays.Sigma * color.Pinhole.FocalXPx * SigmaWidthPx / color.Pinhole.Width);
            return true;
        }

        /// <summary>Both lenses are known, and so is the homography between their rays: a mapping that was fitted before.</summary>
        /// <param name="infrared">The infrared camera.</param>
        /// <param name="color">The colour camera.</param>
        /// <param name="rays">From infrared to colour rays normalised to z = 1; see <see cref="RayHomography"/>.</param>
        /// <param name="sigmaPx">See <see cref="SigmaPx"/>, above zero.</param>
        public static InfraredMapping OfRays(LensCamera infrared, LensCamera color, Homography rays, double sigmaPx) => sigmaPx > 0
            ? new InfraredMapping(infrared, rays, color, sigmaPx)
            : throw new ArgumentException("must be above zero", nameof(sigmaPx));

        /// <summary>Both cameras are known, the screen is taken to face the colour camera at this distance.</summary>
        /// <param name="infrared">The infrared camera.</param>
        /// <param name="color">The colour camera.</param>
        /// <param name="infraredToColorMm">X_color = R X_infrared + T, mm.</param>
        /// <param name="distanceMm">From the colour camera to the screen, above zero. With cameras 32 mm apart a tenth too far is 1 px at 2.5 m.</param>
        public static InfraredMapping OfCameras(LensCamera infrared, LensCamera color, Pose infraredToColorMm, double distanceMm)
        {
            if (!(distanceMm > 0) || double.IsInfinity(distanceMm))
                throw new ArgumentException("the distance to the screen must be above zero", nameof(distanceMm));
            return OnPlane(infrared, color, infraredToColorMm, new Vector3D(0, 0, 1), distanceMm);
        }

        /// <summary>Both cameras are known, and the plane of the screen in the colour camera's space, mm.</summary>
        public static InfraredMapping OnPlane(LensCamera infrared, LensCamera color, Pose infraredToColorMm, Plane3D plane) =>
            OnPlane(infrared, color, infraredToColorMm, plane.Normal, plane.Distance);

        /// <summary>Both cameras are known, and where the screen lies in the colour picture: that gives its plane.</summary>
        /// <exception cref="ArgumentException">The screen's corners lie outside what the colour camera's lens model covers.</exception>
        public static InfraredMapping OnScreen(LensCamera infrared, LensCamera color, Pose infraredToColorMm, ScreenGeometry screen)
        {
            return ScreenPlane.TryFromSize(screen, color, out ScreenPlane? plane, out string reason)
                ? OnPlane(infrared, color, infraredToColorMm, plane!.Plane)
                : throw new ArgumentException(reason, nameof(screen));
        }

        /// <summary>False where a lens model does not reach or the plane is not seen.</summary>
        public bool TryMap(Vector2D infraredPx, out Vector2D colorPx)
        {
            colorPx = infraredPx;
            if (_infrared != null && !_infrared.TryUnproject(infraredPx, out colorPx))
                return false;
            colorPx = _homography.Map(colorPx);
            return colorPx.IsFinite && (_color == null || _color.TryProject(colorPx, out colorPx));
        }

        /// <summary>The plane n·X = d of colour camera space; between the cameras' rays it makes R + T (Rᵀn)ᵀ / (d − n·T).</summary>
        private static InfraredMapping OnPlane(LensCamera infrared, LensCamera color, Pose pose, Vector3D normal, double distanceMm)
        {
            Vector3D x = pose.TransformDirection(new Vector3D(1, 0, 0)), y = pose.TransformDirection(new Vector3D(0, 1, 0)), z = pose.TransformDirection(new Vector3D(0, 0, 1));
            Vector3D t = pose.Position * (1 / (distanceMm - Vector3D.Dot(normal, pose.Position)));
            double nx = Vector3D.Dot(normal, x), ny = Vector3D.Dot(normal, y), nz = Vector3D.Dot(normal, z);
            var homography = new Homography(new[]
            {
                x.X + t.X * nx, y.X + t.X * ny, z.X + t.X * nz,
                x.Y + t.Y * nx, y.Y + t.Y * ny, z.Y + t.Y * nz,
                x.Z + t.Z * nx, y.Z + t.Z * ny, z.Z + t.Z * nz,
            });
            return new InfraredMapping(infrared, homography, color, 0.4);
        }

        private static bool TryUnproject(LensCamera camera, ReadOnlySpan<Vector2D> px, out Vector2D[] rays, out string reason)
        {
            rays = new Vector2D[px.Length];
            for (int i = 0; i < rays.Length; i++)
            {
                if (camera.TryUnproject(px[i], out rays[i]))
                    continue;
                reason = FormattableString.Invariant($"point {i + 1} lies outside what the lens model covers");
                return false;
            }

            reason = string.Empty;
            return true;
        }

        private static bool IsOf(LensCamera? camera, int width, int height) => camera == null || (camera.Pinhole.Width == width && camera.Pinhole.Height == height);
    }
}

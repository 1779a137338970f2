using System;
using System.Runtime.CompilerServices;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Places a saddle point to hundredths of a pixel: least squares of a model over a round window of the full picture. Two straight
    /// edges cross, both spread by one Gaussian blur (error functions), light and shade on top of a plane of brightness. Nine
    /// parameters, Levenberg's method. Straight lines stay straight in perspective, so tilt does not bias it; blur is part of the
    /// model. Thread-safe, allocates nothing.
    /// </summary>
    public static unsafe class SaddlePointRefiner
    {
        /// <summary>Largest radius of the window, px: beyond it a lens's curvature costs more than more pixels give.</summary>
        public const double LargestRadiusPx = 8;

        /// <summary>Smallest radius of the window that can hold nine parameters, px.</summary>
        public const double SmallestRadiusPx = 3;

        private const int Iterations = 25;
        private const double Still = 0.001;
        private const double LargestBlurOfRadius = 0.9;
        private const double LeastBlurPx = 0.3;

        /// <summary>A radius for corners whose neighbours' edges begin this far away.</summary>
        public static double RadiusFor(double spacingPx) =>
            Math.Max(SmallestRadiusPx, Math.Min(LargestRadiusPx, 0.45 * spacingPx));

        /// <summary>Fits the model, beginning with a point that was found.</summary>
        /// <param name="gray">The picture at full resolution, <see cref="PixelFormat.Gray8"/>.</param>
        /// <param name="start">Within about a third of the radius, edges within some twenty degrees.</param>
        /// <param name="radiusPx">Radius of the window; it should see no edge but these two.</param>
        /// <param name="refined">Valid only when true is returned; its quality is the share of the window's variance that the model explains.</param>
        /// <returns>False when it runs away by more than half the radius, leaves the picture, or the fit loses its edges.</returns>
        public static bool TryRefine(Image gray, in SaddlePoint start, double radiusPx, out SaddlePoint refined) =>
            TryRefine(gray, start, radiusPx, 0, default, out refined);

        /// <summary>The same where the contrast is known to grow across the window.</summary>
        /// <param name="gray">The picture at full resolution, <see cref="PixelFormat.Gray8"/>.</param>
        /// <param name="start">As above.</param>
        /// <param name="radiusPx">As above.</param>
        /// <param name="middleLevel">The grey in the middle between light and dark everywhere.</param>
        /// <param name="growthPerPx">By which share the contrast grows a pixel.</param>
        /// <param name="refined">As above.</param>
        public static bool TryRefine(Image gray, in SaddlePoint start, double radiusPx, double middleLevel, Vector2D growthPerPx, out SaddlePoint refined)
        {
            if (gray.Format != PixelFormat.Gray8)
                throw new ArgumentException($"a picture of format {gray.Format} is not grey", nameof(gray));
            refined = default;
            var window = new Window(gray, start.PositionPx, radiusPx, middleLevel, growthPerPx);
            if (!window.IsInside)
                return false;
            double* p = stackalloc double[CrossingModel.Parameters];
            double* trial = stackalloc double[CrossingModel.Parameters];
            double* step = stackalloc double[CrossingModel.Parameters];
            double* normal = stackalloc double[CrossingModel.Parameters * CrossingModel.Parameters];
            double* trialNormal = stackalloc double[CrossingModel.Parameters * CrossingModel.Parameters];
            double* damped = stackalloc double[CrossingModel.Parameters * CrossingModel.Parameters];
            double* gradient = stackalloc double[CrossingModel.Parameters];
            double* trialGradient = stackalloc double[CrossingModel.Parameters];
            CrossingModel.Start(p, start, window.Mean);
            double cost = Accumulate(window, p, normal, gradient), damping = 1e-3;
            for (int iteration = 0; iteration < Iterations; iteration++)
            {
                Damp(normal, damping, damped);
                if (!CrossingModel.TrySolve(damped, gradient, step))
                    return false;
                for (int i = 0; i < CrossingModel.Parameters; i++)
                    trial[i] = p[i] + step[i];
                trial[CrossingModel.Blur] = Math.Max(LeastBlurPx, Math.Min(LargestBlurOfRadius * radiusPx, trial[CrossingModel.Blur]));
                double trialCost = Accumulate(window, trial, trialNormal, trialGradient), move = step[0] * step[0] + step[1] * step[1];
                if (trialCost < cost)
                {
                    Swap(ref p, ref trial);
                    Swap(ref normal, ref trialNormal);
                    Swap(ref gradient, ref trialGradient);
                    cost = trialCost;
                    damping *= 0.1;
                    if (p[0] * p[0] + p[1] * p[1] > radiusPx * radiusPx / 4)
                        return false;
                }
                else
                {
                    damping *= 8;
                }

                if (move < Still * Still)
                    break;
            }

            return CrossingModel.TryRead(p, start, 1 - cost / window.Variance, out refined);
        }

        private static void Swap(ref double* a, ref double* b)
        {
            double* other = a;
            a = b;
            b = other;
        }

        private static void Damp(double* normal, double damping, double* damped)
        {
            for (int i = 0; i < CrossingModel.Parameters * CrossingModel.Parameters; i++)
                damped[i] = normal[i];
            for (int i = 0; i < CrossingModel.Parameters; i++)
                damped[i * (CrossingModel.Parameters + 1)] *= 1 + damping;
        }

        /// <summary>Normal equations (lower triangle) and the sum of squares.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static double Accumulate(in Window window, double* p, double* normal, double* gradient)
        {
            const int Count = CrossingModel.Parameters;
            new Span<double>(normal, Count * Count).Clear();
            new Span<double>(gradient, Count).Clear();
            double* row = stackalloc double[Count];
            var model = new CrossingModel(p);
            double cost = 0;
            for (int y = window.Top; y <= window.Bottom; y++)
            for (int x = window.Left; x <= window.Right; x++)
            {
                double dx = x - window.Center.X, dy = y - window.Center.Y, weight = window.Weight(dx, dy);
                if (weight <= 0)
                    continue;
                double rest = window.Level(x, y) - model.Evaluate(dx, dy, row);
                cost += weight * rest * rest;
                for (int i = 0; i < Count; i++)
                {
                    double weighted = weight * row[i];
                    gradient[i] += weighted * rest;
                    double* line = normal + i * Count;
                    for (int j = 0; j <= i; j++)
                        line[j] += weighted * row[j];
                }
            }

            return cost;
        }

        /// <summary>The pixels of a round window that fades out towards its rim.</summary>
        private readonly struct Window
        {
            public readonly Vector2D Center;
            public readonly int Left, Right, Top, Bottom;
            public readonly double Mean, Variance;
            public readonly bool IsInside;
            private readonly byte* _pixels;
            private readonly int _stride;
            private readonly double _inverseSquare, _middle;
            private readonly Vector2D _growth;

            public Window(Image gray, Vector2D center, double radius, double middle, Vector2D growth)
            {
                _middle = middle;
                _growth = growth;
                Center = center;
                _pixels = gray.Pixels;
                _stride = gray.Stride;
                _inverseSquare = 1 / (radius * radius);
                Mean = Variance = 0;
                bool isInside = center.X - radius >= 0 && center.Y - radius >= 0 && center.X + radius <= gray.Width - 1 && center.Y + radius <= gray.Height - 1;
                IsInside = isInside;
                Left = isInside ? (int)Math.Ceiling(center.X - radius) : 0;
                Top = isInside ? (int)Math.Ceiling(center.Y - radius) : 0;
                Right = isInside ? (int)(center.X + radius) : -1;
                Bottom = isInside ? (int)(center.Y + radius) : -1;
                double sum = 0, squares = 0, weights = 0;
                for (int y = Top; y <= Bottom; y++)
                for (int x = Left; x <= Right; x++)
                {
                    double weight = Math.Max(0, Weight(x - center.X, y - center.Y)), level = Level(x, y);
                    weights += weight;
                    sum += weight * level;
                    squares += weight * level * level;
                }

                if (!(weights > 0))
                    return;
                Mean = sum / weights;
                Variance = Math.Max(1e-9, squares - sum * Mean);
            }

            public double Level(int x, int y) => _growth.Equals(default)
                ? _pixels[(long)y * _stride + x]
                : (_pixels[(long)y * _stride + x] - _middle) * Math.Exp(-_growth.X * (x - Center.X) - _growth.Y * (y - Center.Y));

            public double Weight(double dx, double dy) => 1 - (dx * dx + dy * dy) * _inverseSquare;
        }
    }
}

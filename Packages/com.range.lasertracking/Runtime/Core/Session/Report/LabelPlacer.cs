using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>Finds room for small labels beside their points without covering points or other labels, where that is possible.</summary>
    internal sealed class LabelPlacer
    {
        private readonly List<double[]> _taken = new List<double[]>();
        private readonly double _width;
        private readonly double _height;

        public LabelPlacer(double width, double height)
        {
            _width = width;
            _height = height;
        }

        /// <summary>Keeps a box free of labels.</summary>
        public void Take(double centerX, double centerY, double width, double height) =>
            _taken.Add(new[] { centerX - width / 2, centerY - height / 2, centerX + width / 2, centerY + height / 2 });

        /// <summary>Centre of a label of this size near a point: the nearest of sixteen places that covers least.</summary>
        public Vector2D Place(double x, double y, double width, double height, double gap)
        {
            double least = double.PositiveInfinity;
            Vector2D best = default;
            for (int i = 0; i < 32; i++)
            {
                double angle = (-1 + 2 * (i % 16)) * Math.PI / 16 - Math.PI / 4, reach = gap * (1 + i / 16);
                double cos = Math.Round(Math.Cos(angle), 6), sin = Math.Round(Math.Sin(angle), 6);
                double centerX = x + cos * (reach + width / 2), centerY = y + sin * (reach + height / 2);
                double cost = Overlap(centerX, centerY, width, height) + (i / 16) * 0.5;
                if (centerX < width / 2 || centerX > _width - width / 2 || centerY < height / 2 || centerY > _height - height / 2)
                    cost += width * height;
                if (cost >= least)
                    continue;
                least = cost;
                best = new Vector2D(centerX, centerY);
            }

            Take(best.X, best.Y, width, height);
            return best;
        }

        /// <summary>The first of the heights at which a label of this size covers nothing, or else the first; taken from then on.</summary>
        public double FirstFree(double centerX, double width, double height, params double[] centersY)
        {
            double chosen = centersY[0];
            for (int i = centersY.Length - 1; i >= 0; i--)
            {
                if (Overlap(centerX, centersY[i], width, height) <= 0 && centersY[i] > height && centersY[i] < _height - height)
                    chosen = centersY[i];
            }

            Take(centerX, chosen, width, height);
            return chosen;
        }

        private double Overlap(double centerX, double centerY, double width, double height)
        {
            double sum = 0;
            foreach (double[] box in _taken)
            {
                double across = Math.Min(box[2], centerX + width / 2) - Math.Max(box[0], centerX - width / 2);
                double down = Math.Min(box[3], centerY + height / 2) - Math.Max(box[1], centerY - height / 2);
                if (across > 0 && down > 0)
                    sum += across * down;
            }

            return sum;
        }
    }
}

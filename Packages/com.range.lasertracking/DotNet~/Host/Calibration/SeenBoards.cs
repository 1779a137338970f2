using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;

namespace LaserTracking.Host.Calibration
{
    /// <summary>What one camera saw: a place for each picture, empty where the board was not found.</summary>
    internal sealed class SeenBoards
    {
        /// <param name="names">Of the pictures, as messages name them, each once.</param>
        /// <param name="paths">Of the pictures where there are some, else null each.</param>
        /// <param name="width">Of all pictures, px.</param>
        /// <param name="height">Of all pictures, px.</param>
        public SeenBoards(IReadOnlyList<string> names, IReadOnlyList<string?> paths, int width, int height)
        {
            Names = names;
            Paths = paths;
            Width = width;
            Height = height;
            Views = new BoardView?[names.Count];
            Reasons = new string[names.Count];
        }

        public IReadOnlyList<string> Names { get; }

        public IReadOnlyList<string?> Paths { get; }

        public int Width { get; }

        public int Height { get; }

        public BoardView?[] Views { get; }

        /// <summary>Why there is no view.</summary>
        public string[] Reasons { get; }

        /// <summary>Pictures without a board, with the reason.</summary>
        public IEnumerable<LeftOutView> Missing() => Enumerable.Range(0, Views.Length).Where(i => Views[i] == null).Select(i => new LeftOutView(Names[i], Reasons[i]));
    }
}

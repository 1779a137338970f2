using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>What is known of a cell of the view.</summary>
    internal enum CellKind : byte
    {
        /// <summary>Nothing yet: it has always been as it is.</summary>
        Unknown,

        /// <summary>It changed by itself: projected, or somebody before it.</summary>
        Content,

        /// <summary>It stayed when the projected picture changed, or shows that picture's border: the room.</summary>
        Room,
    }

    /// <summary>
    /// The view in cells of sixteen bins, each with how it looked when it was last taken for resting and what is known of it.
    /// </summary>
    internal sealed class ViewCells
    {
        /// <summary>Variance of levels from which a cell has something to compare.</summary>
        private const double LeastVariance = 50;

        private const double StayFit = 0.9, ChangeFit = 0.7, MostGain = 1.3;

        private double[] _variance = Array.Empty<double>(), _xx = Array.Empty<double>(), _xy = Array.Empty<double>(), _yy = Array.Empty<double>();

        public int Columns { get; private set; }

        public int Rows { get; private set; }

        public int Count => Columns * Rows;

        /// <summary>How it looked at rest.</summary>
        public BinPicture Then { get; } = new BinPicture();

        public CellKind[] Kinds { get; private set; } = Array.Empty<CellKind>();

        /// <summary>1: as then; -1: something else is seen; 0: neither is sure.</summary>
        public sbyte[] States { get; private set; } = Array.Empty<sbyte>();

        /// <summary>Looks for which something else was seen without a break.</summary>
        public byte[] Away { get; private set; } = Array.Empty<byte>();

        /// <summary>Times that it stayed while most of the picture changed.</summary>
        public byte[] Survived { get; private set; } = Array.Empty<byte>();

        private CellKind[] _moved = Array.Empty<CellKind>();

        /// <summary>The picture has enough cells to compare.</summary>
        public bool IsLargeEnough => Columns >= 6 && Rows >= 4;

        /// <summary>Takes the size of a picture; true when it is another one than before.</summary>
        public bool Fit(Imaging.Image image)
        {
            if (!Then.Fit(image))
                return false;
            Columns = Then.Width / CellMatch.Size;
            Rows = Then.Height / CellMatch.Size;
            _variance = new double[Count];
            _xx = new double[Count];
            _xy = new double[Count];
            _yy = new double[Count];
            Kinds = new CellKind[Count];
            _moved = new CellKind[Count];
            States = new sbyte[Count];
            Away = new byte[Count];
            Survived = new byte[Count];
            return true;
        }

        public int X(int cell) => cell % Columns * CellMatch.Size;

        public int Y(int cell) => cell / Columns * CellMatch.Size;

        public bool IsStructured(int cell) => _variance[cell] >= LeastVariance;

        /// <summary>How well a cell shows displacements along both axes, and along one.</summary>
        public double Worth(int cell)
        {
            double half = (_xx[cell] + _yy[cell]) / 2, root = Math.Sqrt((_xx[cell] - _yy[cell]) * (_xx[cell] - _yy[cell]) / 4 + _xy[cell] * _xy[cell]);
            return half - root + 0.1 * (half + root);
        }

        public void Forget()
        {
            Array.Clear(Kinds, 0, Count);
            Array.Clear(Away, 0, Count);
            Array.Clear(Survived, 0, Count);
        }

        /// <summary>A cell as it looks now is what to compare with.</summary>
        public void Take(BinPicture now, int cell)
        {
            Then.CopyFrom(now, X(cell), Y(cell), CellMatch.Size);
            _variance[cell] = CellMatch.Variance(Then, X(cell), Y(cell), out _xx[cell], out _xy[cell], out _yy[cell]);
            Away[cell] = 0;
        }

        /// <summary>What is known of the cells goes with a camera whose picture was displaced, bins.</summary>
        public void Displace(Vector2D shift)
        {
            int dx = (int)Math.Round(shift.X / CellMatch.Size), dy = (int)Math.Round(shift.Y / CellMatch.Size);
            Array.Copy(Kinds, _moved, Count);
            for (int cell = 0; cell < Count; cell++)
            {
                int column = cell % Columns - dx, row = cell / Columns - dy;
                Kinds[cell] = column >= 0 && row >= 0 && column < Columns && row < Rows ? _moved[row * Columns + column] : CellKind.Unknown;
                Survived[cell] = 0;
            }
        }

        /// <summary>Compares a cell with how it was.</summary>
        public void Compare(BinPicture now, int cell)
        {
            if (!IsStructured(cell))
            {
                States[cell] = CellMatch.Variance(now, X(cell), Y(cell), out _, out _, out _) >= 2 * LeastVariance ? (sbyte)-1 : (sbyte)0;
                return;
            }

            // Smooth slopes often run alike by chance: their strength must agree, too.
            double fit = CellMatch.Correlation(Then, now, X(cell), Y(cell), out double gain);
            States[cell] = fit >= StayFit && gain > 1 / MostGain && gain < MostGain ? (sbyte)1 : fit < ChangeFit ? (sbyte)-1 : (sbyte)0;
        }

        public void Add(ViewShift solver, int cell, Vector2D shift) => solver.Add(shift, _xx[cell], _xy[cell], _yy[cell]);
    }
}

namespace LaserTracking.Calibration
{
    /// <summary>One placing of the board seen by both cameras at once. Each may see other points of it.</summary>
    public sealed class BoardPair
    {
        public BoardPair(BoardView left, BoardView right)
        {
            Left = left;
            Right = right;
        }

        public BoardView Left { get; }

        public BoardView Right { get; }

        /// <summary>As messages name it.</summary>
        public string Name => Left.Name + " + " + Right.Name;
    }
}

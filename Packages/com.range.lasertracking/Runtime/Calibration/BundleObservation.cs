namespace LaserTracking.Calibration
{
    /// <summary>One camera's view of one placing of the board.</summary>
    internal readonly struct BundleObservation
    {
        public readonly int Camera;
        public readonly int Board;
        public readonly BoardView View;

        public BundleObservation(int camera, int board, BoardView view)
        {
            Camera = camera;
            Board = board;
            View = view;
        }
    }
}

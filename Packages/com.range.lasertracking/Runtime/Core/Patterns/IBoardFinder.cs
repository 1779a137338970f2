using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>Finds the corners of a checkerboard: our own <see cref="CheckerboardFinder"/>, or a second opinion on it. Not thread-safe.</summary>
    public interface IBoardFinder : IDisposable
    {
        /// <summary>Finds the whole board or says why not.</summary>
        /// <param name="picture">Any format but depth.</param>
        /// <param name="board">Inner corners to find, neither more nor fewer.</param>
        /// <param name="cornersPx">At least <see cref="BoardSize.Count"/> places, filled on success in the order of <see cref="CheckerboardFinder"/>'s remarks; pixels of the picture.</param>
        /// <param name="reason">Empty on success, else one line.</param>
        /// <exception cref="ArgumentException">No picture, a depth picture, too few places, a board size that was never set.</exception>
        bool TryFind(Image picture, BoardSize board, Span<Vector2D> cornersPx, out string reason);
    }
}

using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>What one plane of the search (the smallest or the largest of the three channels) saw at a spot, and what its tile let through.</summary>
    public struct SpotPlane
    {
        /// <summary>The highest rise within a few pixels of the spot: where, in pixels of the whole picture.</summary>
        public Vector2D PeakPx;

        /// <summary>Brightness there, 0…255.</summary>
        public int Level;

        /// <summary>Brightness that its own past explains, 0…255.</summary>
        public int Envelope;

        /// <summary>Rise as a share of the room left to full brightness, 0…1.</summary>
        public double Rise;

        /// <summary>Largest rise beyond a sixteenth of the room left, anywhere in the tile of 16×16 searched pixels, levels.</summary>
        public int TileOnset;

        /// <summary>What that must exceed for the tile to be looked into, levels: most of how large it has been of late.</summary>
        public int TileGate;

        /// <summary>How large it has been of late, levels.</summary>
        public double TileActivity;

        /// <summary>Tiles above their gates in this frame.</summary>
        public int HotTiles;

        /// <summary>This tile was looked into; a hot one is not when too many others rose higher above their gates.</summary>
        public bool IsTileExamined;

        /// <summary>Levels above its own past.</summary>
        public readonly int RiseLevels => Level - Envelope;
    }
}

namespace LaserTracking.Imaging
{
    /// <summary>One component of a JPEG: its sampling and the tables it is coded with.</summary>
    internal struct JpegComponent
    {
        public int Id;
        public int Horizontal;
        public int Vertical;
        public int QuantisationTable;
        public int DcTable;
        public int AcTable;

        /// <summary>Index of its first block among those of a unit.</summary>
        public int FirstBlock;
    }
}

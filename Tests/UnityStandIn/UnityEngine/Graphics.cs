// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Graphics
    {
        /// <summary>Each pixel is the mean of those it covers; for whole numbers of them.</summary>
        public static void Blit(Texture source, RenderTexture dest)
        {
            var from = (RenderTexture)source;
            int across = from.width / dest.width, down = from.height / dest.height;
            for (int y = 0; y < dest.height; y++)
            for (int x = 0; x < dest.width; x++)
            {
                int red = 0, green = 0, blue = 0;
                for (int i = 0; i < across * down; i++)
                {
                    Color32 pixel = from.Content[(y * down + i / across) * from.width + x * across + i % across];
                    red += pixel.r;
                    green += pixel.g;
                    blue += pixel.b;
                }

                dest.Content[y * dest.width + x] = new Color32((byte)(red / (across * down)), (byte)(green / (across * down)), (byte)(blue / (across * down)), 255);
            }
        }
    }
}

package org.dfra.sim.device.camera;

import org.jspecify.annotations.Nullable;

/**
 * How an emulated camera is set up.
 *
 * @param path of its stream; anything else it does not find
 * @param isThermal whether it sends heat, as PNG of 16 bits, or light, as JPEG
 * @param frameRate images per second, above 0
 * @param credentials {@code user:password} that it wants to hear; null where it lets everybody in
 * @param sendsLength whether its parts have a {@code Content-Length}
 * @param sendsTimestamp whether its parts have an {@code X-Timestamp}
 */
public record MjpegOptions(
    String path,
    boolean isThermal,
    double frameRate,
    @Nullable String credentials,
    boolean sendsLength,
    boolean sendsTimestamp) {

  public MjpegOptions {
    if (!(frameRate > 0 && frameRate <= 1000)) {
      throw new IllegalArgumentException("frame rate " + frameRate + " Hz is not 0 to 1000");
    }
  }

  /** A camera of light at {@code /video}, which tells everybody all it can. */
  public static MjpegOptions visible(double frameRate) {
    return new MjpegOptions("/video", false, frameRate, null, true, true);
  }

  /** A camera of heat at {@code /video}, which tells everybody all it can. */
  public static MjpegOptions thermal(double frameRate) {
    return new MjpegOptions("/video", true, frameRate, null, true, true);
  }

  /** The same, for those only who say {@code user:password}. */
  public MjpegOptions withCredentials(String userAndPassword) {
    return new MjpegOptions(
        path, isThermal, frameRate, userAndPassword, sendsLength, sendsTimestamp);
  }

  /** The same, whose parts have neither length nor time. */
  public MjpegOptions withoutPartHeaders() {
    return new MjpegOptions(path, isThermal, frameRate, credentials, false, false);
  }
}

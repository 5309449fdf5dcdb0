package org.dfra.sim.device.camera;

import org.jspecify.annotations.Nullable;

/**
 * Settings of an emulated camera.
 *
 * @param path of its stream; other paths are not found
 * @param isThermal true for a thermal camera, 16-bit PNG; false for visible light, JPEG
 * @param frameRate images per second, above 0
 * @param credentials {@code user:password} that it requires; null for no authentication
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

  /** A visible-light camera at {@code /video} that sends lengths and timestamps. */
  public static MjpegOptions visible(double frameRate) {
    return new MjpegOptions("/video", false, frameRate, null, true, true);
  }

  /** A thermal camera at {@code /video} that sends lengths and timestamps. */
  public static MjpegOptions thermal(double frameRate) {
    return new MjpegOptions("/video", true, frameRate, null, true, true);
  }

  /** The same, with authentication as {@code user:password}. */
  public MjpegOptions withCredentials(String userAndPassword) {
    return new MjpegOptions(
        path, isThermal, frameRate, userAndPassword, sendsLength, sendsTimestamp);
  }

  /** The same, without lengths and timestamps of its parts. */
  public MjpegOptions withoutPartHeaders() {
    return new MjpegOptions(path, isThermal, frameRate, credentials, false, false);
  }
}

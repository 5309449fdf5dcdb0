package org.dfra.drivers.camera.mjpeg;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.config.Parameters;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;
import org.dfra.drivers.link.TcpAddress;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * The checked parameters of a camera; see {@link MjpegCameraImpl}.
 *
 * @param address the camera's address
 * @param path of its stream
 * @param user user name; empty without authentication
 * @param authorization the authorization header; must not be shown
 * @param band the spectral band
 * @param fieldOfView from the left edge to the right, radians
 * @param frameRate images per second, as configured on the camera
 * @param idlePeriod seconds from one image to the next without clients; 0: the same as with clients
 * @param maxImageBytes maximum size of an image, bytes
 */
record MjpegSettings(
    LinkAddress address,
    String path,
    String user,
    String authorization,
    Band band,
    double fieldOfView,
    double frameRate,
    double idlePeriod,
    int maxImageBytes) {

  static final double NARROWEST = 0.001;
  static final double WIDEST = 3.1;
  static final double LONGEST_IDLE = 3600;

  private static final int USUAL_LARGEST = 4 * 1024 * 1024;

  /**
   * Reads the parameters.
   *
   * @throws org.dfra.core.config.ConfigurationException if one is missing or wrong
   */
  static MjpegSettings of(Parameters parameters) {
    String user = parameters.find("user").orElse("");
    return new MjpegSettings(
        address(parameters),
        path(parameters),
        user,
        authorization(parameters, user),
        band(parameters),
        fieldOfView(parameters),
        parameters.number("frame_rate", 10, 0.1, 120),
        parameters.number("idle_period", 10, 0, LONGEST_IDLE),
        (int) parameters.number("max_image_bytes", USUAL_LARGEST, 10_000, 64.0 * 1024 * 1024));
  }

  private static LinkAddress address(Parameters parameters) {
    LinkAddress address = LinkSettings.address(parameters);
    if (!(address instanceof TcpAddress || address instanceof SimAddress)) {
      throw parameters.fault("link", "a network camera's; write tcp://host:port", null);
    }
    return address;
  }

  private static String path(Parameters parameters) {
    String path = parameters.find("path").orElse("/");
    if (!path.matches("/[\\x21-\\x7E]*")) {
      throw parameters.fault(
          "path", "a path: it begins with a slash and has neither blanks nor accents", null);
    }
    return path;
  }

  private static String authorization(Parameters parameters, String user) {
    Optional<String> password = parameters.find("password");
    if (user.isEmpty()) {
      // With a password this reports that the user is not set, without showing the password.
      return password.isPresent() ? parameters.text("user") : "";
    }
    if (user.contains(":") || user.matches("(?s).*\\p{Cntrl}.*")) {
      throw parameters.fault("user", "a user's name without colons", null);
    }
    byte[] both = (user + ":" + password.orElse("")).getBytes(StandardCharsets.UTF_8);
    return "Basic " + Base64.getEncoder().encodeToString(both);
  }

  private static Band band(Parameters parameters) {
    String band = parameters.find("band").orElse("visible");
    for (Band each : Band.values()) {
      if (each.name().toLowerCase(Locale.ROOT).equals(band)) {
        return each;
      }
    }
    throw parameters.fault("band", "visible or thermal", null);
  }

  private static double fieldOfView(Parameters parameters) {
    String unused = parameters.text("field_of_view"); // required: there is no sensible default
    return parameters.number("field_of_view", Double.NaN, NARROWEST, WIDEST);
  }

  /** The HTTP request, sent once for each stream. */
  byte[] request() {
    String host = address.toString().replaceFirst("^[a-z]+:(//)?", "");
    String request =
        "GET "
            + path
            + " HTTP/1.0\r\nHost: "
            + host
            + "\r\nUser-Agent: DFRA\r\nAccept: multipart/x-mixed-replace, */*;q=0.5\r\n"
            + (authorization.isEmpty() ? "" : "Authorization: " + authorization + "\r\n")
            + "\r\n";
    return request.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** The required media type of the images. */
  String mediaType() {
    return band == Band.THERMAL ? "image/png" : "image/jpeg";
  }

  /** Omits the credentials. */
  @Override
  public String toString() {
    return "MjpegSettings[address=" + address + ", path=" + path + ", band=" + band + "]";
  }
}

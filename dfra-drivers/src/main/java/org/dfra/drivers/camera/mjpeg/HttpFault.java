package org.dfra.drivers.camera.mjpeg;

import java.util.Locale;

/** Explains why a response is not an image stream, and what to do about it. */
final class HttpFault {

  private HttpFault() {}

  /**
   * The fault in a response; empty where it is an image stream.
   *
   * @param head its head
   * @param path the requested path
   * @param user user name of the request; empty without authentication
   */
  static String of(HttpHeader head, String path, String user) {
    String answer = (head.status() + " " + head.reason()).strip();
    return switch (head.status()) {
      case 200 -> ofBody(head, path);
      case 301, 302, 303, 307, 308 ->
          "the camera redirects to \""
              + withoutUser(head.header("location"))
              + "\" ("
              + answer
              + "); set link and path to where its stream is";
      case 401 -> unauthorized(head, answer, user);
      case 403 ->
          "the camera forbids "
              + path
              + " ("
              + answer
              + "); give the user that right, or set another user";
      case 404 -> "the camera has nothing at " + path + " (" + answer + "); set path to its stream";
      default -> "the camera answers " + answer + "; look at the camera";
    };
  }

  private static String ofBody(HttpHeader head, String path) {
    if (head.header("transfer-encoding").toLowerCase(Locale.ROOT).contains("chunked")) {
      return "the camera sends chunks in HTTP/1.0, which does not define them; look for a proxy between";
    }
    if (head.boundary().isEmpty()) {
      String type = head.header("content-type");
      return "the content of "
          + path
          + " is not a stream of images but "
          + (type.isEmpty() ? "of no type" : type)
          + "; set path to the camera's multipart stream";
    }
    return "";
  }

  private static String unauthorized(HttpHeader head, String answer, String user) {
    String challenge = head.header("www-authenticate").toLowerCase(Locale.ROOT);
    if (!challenge.isEmpty() && !challenge.contains("basic")) {
      return "the camera requires authentication by "
          + challenge.split("\\s", 2)[0]
          + " ("
          + answer
          + "), but only basic is supported; set the camera to basic";
    }
    return user.isEmpty()
        ? "the camera requires authentication (" + answer + "); set user and password"
        : "the camera rejects user "
            + user
            + " with this password ("
            + answer
            + "); set user and password";
  }

  /** Removes the user name and the password from a redirect's location. */
  private static String withoutUser(String location) {
    return location.replaceFirst("//[^/@]*@", "//");
  }
}

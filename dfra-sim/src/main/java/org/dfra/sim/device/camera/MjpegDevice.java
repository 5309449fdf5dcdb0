package org.dfra.sim.device.camera;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Base64;
import java.util.Locale;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.physics.CameraInput;
import org.jspecify.annotations.Nullable;

/**
 * Emulates a network camera: it answers one HTTP request per connection, with a stream of images at
 * its frame rate or with an error.
 *
 * <p>The network is as fast as its client reads. If the client reads more slowly than frames are
 * due, the camera skips whole frames; it renders only frames that it sends.
 */
public final class MjpegDevice implements SerialDevice {

  private static final int LONGEST_REQUEST = 8192;
  private static final String BOUNDARY = "dfra-frame";

  private enum State {
    LISTENING,
    STREAMING,
    SILENT
  }

  private final CameraInput view;
  private final MjpegOptions options;
  private final FrameEncoder encoder;
  private final Duration period;
  private final StringBuilder request = new StringBuilder();
  private final ArrayDeque<ByteBuffer> waiting = new ArrayDeque<>();
  private State state = State.SILENT; // until a client connects
  private Instant next = Instant.MAX; // when the next frame is due

  /**
   * @param view input of its sensor
   * @param options its settings
   */
  public MjpegDevice(CameraInput view, MjpegOptions options) {
    this.view = view;
    this.options = options;
    this.encoder = new FrameEncoder(options.band());
    this.period = Duration.ofNanos(Math.round(1e9 / options.frameRate()));
  }

  @Override
  public boolean buffersOutput() {
    return true;
  }

  @Override
  public void connected() {
    begin(State.LISTENING);
  }

  @Override
  public void disconnected() {
    begin(State.SILENT);
  }

  private void begin(State first) {
    state = first;
    request.setLength(0);
    waiting.clear();
    next = Instant.MAX;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    if (state != State.LISTENING) {
      return;
    }
    request.append(new String(bytes, offset, length, StandardCharsets.ISO_8859_1));
    if (request.indexOf("\r\n\r\n") >= 0) {
      answer(time);
    } else if (request.length() > LONGEST_REQUEST) {
      refuse("431 Request Header Fields Too Large", "");
    }
  }

  private void answer(Instant time) {
    String[] lines = request.toString().split("\r\n");
    String[] words = lines[0].split(" ");
    if (words.length != 3 || !words[2].startsWith("HTTP/1.")) {
      refuse("400 Bad Request", "");
    } else if (!words[0].equals("GET")) {
      refuse("405 Method Not Allowed", "Allow: GET\r\n");
    } else if (!isAuthorized(lines)) {
      refuse("401 Unauthorized", "WWW-Authenticate: Basic realm=\"camera\"\r\n");
    } else if (!words[1].equals(options.path())) {
      refuse("404 Not Found", "");
    } else {
      state = State.STREAMING;
      next = time;
      enqueue(
          "HTTP/1.0 200 OK\r\nServer: camera\r\nConnection: close\r\nCache-Control: no-cache\r\n"
              + "Content-Type: multipart/x-mixed-replace;boundary="
              + BOUNDARY
              + "\r\n\r\n");
    }
  }

  private boolean isAuthorized(String[] lines) {
    String credentials = options.credentials();
    if (credentials == null) {
      return true;
    }
    byte[] expected = credentials.getBytes(StandardCharsets.UTF_8);
    String header = "authorization: basic ";
    for (String line : lines) {
      if (line.toLowerCase(Locale.ROOT).startsWith(header)) {
        return line.substring(header.length())
            .strip()
            .equals(Base64.getEncoder().encodeToString(expected));
      }
    }
    return false;
  }

  private void refuse(String status, String header) {
    state = State.SILENT;
    String body = status + "\n";
    enqueue(
        "HTTP/1.0 "
            + status
            + "\r\n"
            + header
            + "Content-Type: text/plain\r\nContent-Length: "
            + body.length()
            + "\r\nConnection: close\r\n\r\n"
            + body);
  }

  @Override
  public void transmit(ByteBuffer out, Instant time) {
    if (state == State.STREAMING && waiting.isEmpty() && !time.isBefore(next)) {
      sendFrame(time);
    }
    for (ByteBuffer head = waiting.peek(); head != null && out.hasRemaining(); ) {
      int count = Math.min(head.remaining(), out.remaining());
      out.put(head.slice().limit(count));
      head.position(head.position() + count);
      if (!head.hasRemaining()) {
        waiting.remove();
        head = waiting.peek();
      }
    }
  }

  private void sendFrame(Instant time) {
    long missed = Duration.between(next, time).dividedBy(period);
    Instant due = next.plus(period.multipliedBy(missed));
    next = due.plus(period);
    byte[] image = encoder.encode(view.capture(due));
    enqueue(
        "--"
            + BOUNDARY
            + "\r\nContent-Type: "
            + encoder.mediaType()
            + "\r\n"
            + partHeaders(image, due)
            + "\r\n");
    waiting.add(ByteBuffer.wrap(image));
    enqueue("\r\n");
  }

  private String partHeaders(byte[] image, Instant taken) {
    return switch (options.partHeaders()) {
      case LENGTH_AND_TIMESTAMP ->
          "Content-Length: " + image.length + "\r\nX-Timestamp: " + seconds(taken) + "\r\n";
      case NONE -> "";
    };
  }

  private static String seconds(Instant time) {
    return String.format(Locale.ROOT, "%d.%06d", time.getEpochSecond(), time.getNano() / 1000);
  }

  private void enqueue(String text) {
    waiting.add(ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1)));
  }

  /**
   * Settings of an emulated camera.
   *
   * @param path of its stream; other paths are not found
   * @param band thermal, 16-bit PNG, or visible light, JPEG
   * @param frameRate images per second, above 0
   * @param credentials {@code user:password} that it requires; null for no authentication
   * @param partHeaders optional headers of its parts
   */
  public record MjpegOptions(
      String path,
      Band band,
      double frameRate,
      @Nullable String credentials,
      PartHeaders partHeaders) {

    /** Optional headers of each part. */
    public enum PartHeaders {
      /** {@code Content-Length} and {@code X-Timestamp}. */
      LENGTH_AND_TIMESTAMP,
      /** Neither. */
      NONE
    }

    public MjpegOptions {
      if (!(frameRate > 0 && frameRate <= 1000)) {
        throw new IllegalArgumentException(
            "frame rate " + frameRate + " Hz must be above 0 Hz and at most 1000 Hz");
      }
    }

    /** A visible-light camera at {@code /video} that sends lengths and timestamps. */
    public static MjpegOptions visible(double frameRate) {
      return new MjpegOptions(
          "/video", Band.VISIBLE, frameRate, null, PartHeaders.LENGTH_AND_TIMESTAMP);
    }

    /** A thermal camera at {@code /video} that sends lengths and timestamps. */
    public static MjpegOptions thermal(double frameRate) {
      return new MjpegOptions(
          "/video", Band.THERMAL, frameRate, null, PartHeaders.LENGTH_AND_TIMESTAMP);
    }

    /** The same, with authentication as {@code user:password}. */
    public MjpegOptions withCredentials(String userAndPassword) {
      return new MjpegOptions(path, band, frameRate, userAndPassword, partHeaders);
    }

    /** The same, without lengths and timestamps of its parts. */
    public MjpegOptions withoutPartHeaders() {
      return new MjpegOptions(path, band, frameRate, credentials, PartHeaders.NONE);
    }
  }
}

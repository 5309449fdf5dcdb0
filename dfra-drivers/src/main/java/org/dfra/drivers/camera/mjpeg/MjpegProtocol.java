package org.dfra.drivers.camera.mjpeg;

import java.io.IOException;
import java.time.Duration;
import java.util.function.DoubleSupplier;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Ended;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Malformed;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Part;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Response;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;

/**
 * Controls the connection: when to request a stream, and when to close it.
 *
 * <pre>
 *            opened: GET
 *                v
 *   +------&gt; STREAMING   takes images
 *   |            v an image has arrived, and there are no clients
 *   |        IDLE        not connected
 *   |            v a client has arrived, or the idle period is over: reconnects, GET
 *   +------------+
 *
 *   an error, an end, silence --&gt; the link is reopened, by its back-off
 * </pre>
 *
 * <p>Confined to the reader.
 */
final class MjpegProtocol implements DeviceProtocol {

  /** Receives the events; called by the reader. */
  interface Listener {

    /**
     * An image has arrived.
     *
     * @return why it is not served, as a clause; empty if it is
     */
    String imageReceived(Part part);

    /** A part was not an image. */
    void refused(String reason);

    /** The camera is lost. */
    void lost(String reason);
  }

  private static final Duration SILENCE = Duration.ofSeconds(5);

  private final MjpegSettings settings;
  private final Ticker ticker;
  private final DoubleSupplier idlePeriod;
  private final Listener listener;
  private final MjpegParser parser;

  private String fault = ""; // why the stream must be reopened; empty without a fault
  private String refusal = ""; // why the last image was not served; empty if it was
  private long refusedNanos; // when that image arrived
  private boolean hasSeen; // an image has arrived since it was connected
  private volatile boolean isIdle; // also read by threads that wait for an image
  private volatile long connectedNanos;
  private volatile long lifeNanos; // when the last image arrived, or the link was reopened

  /**
   * @param idlePeriod current time from one image to the next, seconds; 0 while streaming is
   *     required
   */
  MjpegProtocol(
      MjpegSettings settings, Ticker ticker, DoubleSupplier idlePeriod, Listener listener) {
    this.settings = settings;
    this.ticker = ticker;
    this.idlePeriod = idlePeriod;
    this.listener = listener;
    this.parser = new MjpegParser(settings.maxImageBytes(), this::messageReceived);
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    lifeNanos = ticker.nanos();
    sendRequest(link);
  }

  private void sendRequest(SerialLink link) throws IOException {
    fault = "";
    refusal = "";
    hasSeen = false;
    isIdle = false;
    connectedNanos = ticker.nanos();
    link.write(settings.request());
  }

  @Override
  public MjpegParser parser() {
    return parser;
  }

  @Override
  public void periodic(SerialLink link) throws IOException {
    if (!fault.isEmpty()) {
      throw new IOException(link + ": " + fault);
    }
    double period = idlePeriod.getAsDouble();
    SuspendableLink suspendable = (SuspendableLink) link;
    if (suspendable.isResting()) {
      if (ticker.nanos() - connectedNanos >= Math.round(period * 1e9)) {
        suspendable.resume();
        sendRequest(link);
      }
    } else if (period > 0 && hasSeen) {
      suspendable.suspend();
      isIdle = true;
      parser.finish();
    }
  }

  @Override
  public Duration livenessTimeout() {
    // Counted from the last image, which may be old when the camera is reconnected.
    return isIdle
        ? SILENCE.plusNanos(Math.round(idlePeriod.getAsDouble() * 1e9))
        : SILENCE.plusNanos(Math.max(0, connectedNanos - lifeNanos));
  }

  @Override
  public String expected() {
    return "image";
  }

  /** A camera that still sends images, but not the configured ones, is not silent for its user. */
  @Override
  public String silenceReason(Duration timeout) {
    boolean isSending = ticker.nanos() - refusedNanos < SILENCE.toNanos();
    return refusal.isEmpty() || !isSending ? DeviceProtocol.super.silenceReason(timeout) : refusal;
  }

  @Override
  public void lost(String reason) {
    listener.lost(reason);
  }

  private void messageReceived(MjpegMessage message) {
    if (message instanceof Response response) {
      fault = HttpFault.of(response.head(), settings.path(), settings.user());
    } else if (message instanceof Part part) {
      refusal = listener.imageReceived(part);
      refusedNanos = ticker.nanos();
      if (refusal.isEmpty()) {
        hasSeen = true;
        lifeNanos = ticker.nanos();
      }
    } else if (message instanceof Malformed malformed) {
      listener.refused(malformed.reason());
    } else if (message instanceof Ended ended && fault.isEmpty()) {
      fault = ended.reason();
    }
  }
}

package org.dfra.drivers.camera.mjpeg;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Part;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.CameraAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A network camera that streams images over HTTP: visible light as JPEG; thermal as 16-bit grey
 * PNG, in hundredths of a kelvin.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}: {@code tcp://host:port}; required. {@code reopen_initial_delay}, {@code
 *       reopen_max_delay}: see {@link org.dfra.drivers.link.LinkSettings}
 *   <li>{@code path}: path of the stream on the camera; default {@code /}
 *   <li>{@code user}, {@code password}: for cameras that require basic authentication; never shown,
 *       never logged
 *   <li>{@code band}: {@code visible} or {@code thermal}; default visible
 *   <li>{@code field_of_view}: from the left edge to the right, radians, 0.001 to 3.1; required;
 *       can be set while it runs
 *   <li>{@code frame_rate}: images per second, as configured on the camera, 0.1 to 120; default 10
 *   <li>{@code idle_period}: seconds from one image to the next while there are no clients, 0 to
 *       3600; default 10; the connection is closed in between. 0: it always streams. Can be set
 *       while it runs
 *   <li>{@code max_image_bytes}: bytes, 10 000 to 64 Mi; a larger image is dropped and counted;
 *       default 4 Mi
 *   <li>{@code mount_frame} and so on: the camera's pose; it looks along x of its frame. See {@link
 *       org.dfra.core.module.DeviceImpl}
 *   <li>read-only: {@code frames}, {@code dropped_bytes}, {@code malformed_frames}
 * </ul>
 *
 * <p>An image has the time of the camera's {@code X-Timestamp} (seconds since 1970) where that is
 * within 10 s of this computer's time, else its time of arrival.
 *
 * <p>The module is INITIALIZING until the first image, and again, with the reason, when the link is
 * lost or the camera answers with an error, ends the stream, or sends no image for 5 s. An image is
 * served for 5 s; while the camera is idle, for the idle period longer.
 *
 * <p>Tests: {@code link}, {@code readings} (images arrive), {@code image} (the next image can be
 * decoded and has visible content). Recovery: {@code reopen_link}.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@code start} to {@code close}.
 */
public final class MjpegCameraImpl extends LinkedSensorImpl<CameraImage> implements CameraSensor {

  private static final Duration OLDEST = Duration.ofSeconds(5);

  /**
   * A larger clock difference means that the camera's clock was never set, or counts from its
   * start.
   */
  private static final Duration MOST_OFF = Duration.ofSeconds(10);

  private static final List<Precondition> PRECONDITIONS =
      List.of(new Precondition("temperature", -10, 50, "°C"));

  private final MjpegSettings written;
  private final DeviceLink deviceLink;

  private volatile double fieldOfView;
  private volatile double idlePeriod;
  private volatile boolean hasClients;
  private volatile @Nullable CameraAttributes can; // null before the first image

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public MjpegCameraImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  MjpegCameraImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(context, "network camera, MJPEG", List.of("CameraImage"), PRECONDITIONS, "image", ticker);
    this.written = MjpegSettings.of(settings());
    this.fieldOfView = written.fieldOfView();
    this.idlePeriod = written.idlePeriod();
    LinkKeeper.Source connecting = source == null ? () -> written.address().open(ticker) : source;
    MjpegProtocol protocol =
        new MjpegProtocol(written, ticker, this::requiredIdlePeriod, new Camera());
    this.deviceLink =
        new DeviceLink(
            context, protocol, ticker, () -> SuspendableLink.open(connecting, ticker), log);
    this.deviceLink.declareIn(diagnostics(), parameterTable());
    ImageDiagnostics image = new ImageDiagnostics(deviceLink, protocol, this::image);
    diagnostics().addTest("image", image::checkNextImage);
    declareParameters();
  }

  private void declareParameters() {
    parameterTable().declareReadOnly("password", "never shown", () -> "");
    parameterTable()
        .declareNumber(
            "field_of_view",
            "angle from the left edge to the right",
            ParameterTable.NumberRange.of(MjpegSettings.NARROWEST, MjpegSettings.WIDEST, "rad"),
            () -> fieldOfView,
            value -> fieldOfView = value);
    parameterTable()
        .declareNumber(
            "idle_period",
            "time from one image to the next without clients, 0: it streams all the time",
            ParameterTable.NumberRange.of(0, MjpegSettings.LONGEST_IDLE, "s"),
            () -> idlePeriod,
            value -> idlePeriod = value);
  }

  /** Current time from one image to the next, seconds; 0 while streaming is required. */
  private double requiredIdlePeriod() {
    return hasClients ? 0 : idlePeriod;
  }

  @Override
  protected ReopeningLink link() {
    return deviceLink;
  }

  @Override
  protected void onClientCount(int number) {
    hasClients = number > 0; // the reader polls it every 0.1 s
  }

  @Override
  public double updateRate() {
    double period = requiredIdlePeriod();
    return period > 0 ? Math.min(1 / period, written.frameRate()) : written.frameRate();
  }

  @Override
  public CameraImage image() {
    return latest().get();
  }

  @Override
  protected Duration longestAge() {
    return OLDEST.plusNanos(Math.round(idlePeriod * 1e9));
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    List<Attributes> all = new ArrayList<>();
    double most = written.frameRate();
    double least = idlePeriod > 0 ? Math.min(1 / idlePeriod, most) : most;
    String condition =
        written.band() == Band.VISIBLE ? "There is light." : "Nothing hot is close to the lens.";
    all.add(
        new SensorAttributes(
            "CameraImage", List.of("stream"), least, most, null, List.of(condition)));
    CameraAttributes known = can;
    if (known != null) {
      all.add(known);
    }
    return all;
  }

  /** Handles what the camera sends; on the reader thread. */
  private final class Camera implements MjpegProtocol.Listener {

    @Override
    public String imageReceived(Part part) {
      ImageFormat shape = part.shape();
      boolean isThermal = written.band() == Band.THERMAL;
      boolean isRight =
          shape.mediaType().equals(written.mediaType())
              && (!isThermal || (shape.isGrey() && shape.bits() == 16));
      if (!isRight) {
        String why =
            "the camera sends "
                + shape.mediaType()
                + " of "
                + shape.bits()
                + " bits, but band "
                + (isThermal ? "thermal is image/png, grey with 16 bits" : "visible is image/jpeg");
        latest().setMissing(why);
        log.debug("{}: {}", path(), why);
        return why;
      }
      serve(part);
      return "";
    }

    private void serve(Part part) {
      ImageFormat shape = part.shape();
      double angle = fieldOfView;
      double focalLength = shape.width() / 2.0 / Math.tan(angle / 2);
      CameraImage image =
          new CameraImage(
              taken(part),
              frame(),
              written.band(),
              shape.width(),
              shape.height(),
              focalLength,
              shape.mediaType(),
              part.data());
      can = new CameraAttributes(written.band(), shape.width(), shape.height(), angle);
      latest().set(image);
      deviceLink.reportAlive();
      deviceLink.eventCounter().increment(ImageDiagnostics.IMAGE);
      publish(image);
    }

    /** When the image was taken: the camera's time where it is plausible, else the current time. */
    private Instant taken(Part part) {
      Instant now = clock().instant();
      return TimestampParser.of(part.head().header("x-timestamp"))
          .filter(reported -> Duration.between(reported, now).abs().compareTo(MOST_OFF) <= 0)
          .orElse(now);
    }

    @Override
    public void refused(String reason) {
      log.debug("{}: {}", path(), reason);
      if (readiness() == Readiness.INITIALIZING) {
        latest().setMissing(reason);
      }
    }

    @Override
    public void lost(String reason) {
      latest().markLost(reason);
    }
  }

  /** Reads {@code X-Timestamp}: seconds since 1970, UTC, with decimals. */
  private static final class TimestampParser {

    private static final Pattern SECONDS = Pattern.compile("([0-9]{1,10})(?:\\.([0-9]{1,9}))?");

    private TimestampParser() {}

    /** Parses the time; empty where the text is invalid. */
    static Optional<Instant> of(String text) {
      Matcher matcher = SECONDS.matcher(text);
      if (!matcher.matches()) {
        return Optional.empty();
      }
      String decimals = matcher.group(2) == null ? "" : matcher.group(2);
      long nanos = Long.parseLong((decimals + "000000000").substring(0, 9));
      return Optional.of(Instant.ofEpochSecond(Long.parseLong(matcher.group(1)), nanos));
    }
  }
}

package org.dfra.drivers.gyro.kvh;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Malformed;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Rate;
import org.dfra.drivers.gyro.kvh.Dsp3000Parser.Dsp3000Decoder;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The fibre-optic rate gyro KVH DSP-3000 on a serial link: 38400 8N1, 100 lines per second.
 *
 * <p>The gyro reports clockwise as +; this driver reports left as +, in radians per second, with
 * the bias subtracted.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}, {@code reopen_initial_delay}, {@code reopen_max_delay}: see {@link
 *       org.dfra.drivers.link.LinkSettings}; the link is required
 *   <li>{@code inverted}: {@code true} for a gyro that is mounted upside down; default {@code
 *       false}; can be set while it runs
 *   <li>{@code bias}: the reported rate of a stationary gyro, radians per second, left is +,
 *       −{@value #MOST_BIAS} to {@value #MOST_BIAS}; default 0; can be set while it runs, also by
 *       the recovery {@code calibrate_bias_while_stationary}
 *   <li>{@code mount_frame} and so on: see {@link org.dfra.core.module.DeviceImpl}
 *   <li>read-only: {@code frames}, {@code dropped_bytes}, {@code malformed_frames}
 * </ul>
 *
 * <p>The module is INITIALIZING until {@value #TRUSTED} consecutive lines were valid, and again
 * when the link is lost, when no line has been received for 2 s, or when the gyro reports that its
 * rate is not valid. A rate is served for 0.5 s.
 *
 * <p>Tests: {@code link}, {@code readings} (lines arrive), {@code validity} (the next line is
 * valid). Recoveries: {@code reopen_link}; {@code calibrate_bias_while_stationary}: sets the bias
 * to the mean of 5 s, and fails if the gyro measures a rotation. The caller must ensure that the
 * robot is stationary.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@code start} to {@code close}.
 */
public final class Dsp3000Impl extends LinkedSensorImpl<AngularRate> implements AngularRateSensor {

  static final double HERTZ = 100;
  static final double MOST_BIAS = 0.1;
  static final int TRUSTED = 10;

  private static final String LINE = "line";
  private static final String MEAN = "mean";
  private static final Duration OLDEST = Duration.ofMillis(500);
  private static final Duration NEXT = Duration.ofSeconds(2);
  private static final Duration MEASURING = Duration.ofSeconds(15);

  private static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("turn rate", -Dsp3000Decoder.FASTEST, Dsp3000Decoder.FASTEST, "°/s"),
          new Precondition("temperature", -40, 75, "°C"));

  private final DeviceLink deviceLink;

  private volatile boolean inverted;
  private volatile double bias;
  private volatile boolean lastWasValid;
  private volatile @Nullable StationaryBiasEstimator measuring; // null while no bias is measured

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public Dsp3000Impl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  Dsp3000Impl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "fibre-optic rate gyro, KVH DSP-3000",
        List.of("AngularRate"),
        PRECONDITIONS,
        "rate",
        ticker);
    this.inverted = invertedIn(settings().find("inverted").orElse("false"));
    this.bias = settings().number("bias", 0, -MOST_BIAS, MOST_BIAS);
    this.deviceLink = new DeviceLink(context, new Gyro(), ticker, source, log);
    this.deviceLink.declareIn(diagnostics(), parameterTable());
    diagnostics().addTest("validity", this::validity);
    diagnostics().addRecovery("calibrate_bias_while_stationary", this::zero);
    parameterTable()
        .declareText(
            "inverted",
            "whether it is mounted upside down, true or false",
            () -> Boolean.toString(inverted),
            text -> inverted = parseBoolean(text));
    parameterTable()
        .declareNumber(
            "bias",
            "the rate that it reports while it is stationary, to the left +",
            ParameterTable.NumberRange.of(-MOST_BIAS, MOST_BIAS, "rad/s"),
            () -> bias,
            value -> bias = value);
  }

  private boolean invertedIn(String text) {
    try {
      return parseBoolean(text);
    } catch (IllegalArgumentException e) {
      throw settings().fault("inverted", String.valueOf(e.getMessage()), e);
    }
  }

  private static boolean parseBoolean(String text) {
    if (!text.equals("true") && !text.equals("false")) {
      throw new IllegalArgumentException("true or false");
    }
    return text.equals("true");
  }

  @Override
  protected ReopeningLink link() {
    return deviceLink;
  }

  @Override
  protected Duration longestAge() {
    return OLDEST;
  }

  @Override
  public double updateRate() {
    return HERTZ;
  }

  @Override
  public AngularRate rate() {
    return latest().get();
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return List.of(
        new SensorAttributes(
            "AngularRate",
            List.of("rate"),
            HERTZ,
            HERTZ,
            null,
            List.of("It turns no faster than 375°/s.")));
  }

  private DiagnosticFinding validity() throws InterruptedException {
    DiagnosticFinding link = deviceLink.link();
    if (!link.passed()) {
      return link;
    }
    if (!deviceLink.eventCounter().await(LINE, deviceLink.eventCounter().total(LINE), NEXT)) {
      return new DiagnosticFinding(false, "no line has come within " + LatestReading.seconds(NEXT));
    }
    return lastWasValid
        ? new DiagnosticFinding(true, "the gyro reports that its rate is valid")
        : new DiagnosticFinding(
            false, "the gyro says that its rate is not valid: it starts, or is broken");
  }

  private DiagnosticFinding zero() throws InterruptedException {
    if (!readiness().serves()) {
      return new DiagnosticFinding(false, "it reports no valid rate: " + latest().missing());
    }
    StationaryBiasEstimator mean = new StationaryBiasEstimator();
    long before = deviceLink.eventCounter().total(MEAN);
    measuring = mean;
    boolean done = deviceLink.eventCounter().await(MEAN, before, MEASURING);
    measuring = null;
    if (!done) {
      return new DiagnosticFinding(
          false,
          "it has not sent "
              + StationaryBiasEstimator.READINGS
              + " valid rates within "
              + LatestReading.seconds(MEASURING));
    }
    DiagnosticFinding finding = mean.finding();
    if (finding.passed()) {
      bias = mean.bias();
    }
    return finding;
  }

  /** The gyro's protocol; on the reader thread. */
  private final class Gyro implements DeviceProtocol {

    /** Rate mode; sent three times, because the gyro sometimes misses a character. */
    private static final String RATE_MODE = "RRR";

    private static final Duration SILENCE = Duration.ofSeconds(2);

    private final Dsp3000Parser parser = new Dsp3000Parser(this::messageReceived);
    private int valid; // consecutive lines

    @Override
    public void opened(SerialLink link) throws IOException {
      valid = 0;
      latest().setMissing(link + " is open, no line has come yet");
      link.write(RATE_MODE.getBytes(StandardCharsets.US_ASCII));
    }

    @Override
    public Dsp3000Parser parser() {
      return parser;
    }

    @Override
    public Duration livenessTimeout() {
      return SILENCE;
    }

    @Override
    public String expected() {
      return "line";
    }

    private void messageReceived(Dsp3000Message message) {
      if (message instanceof Rate rate) {
        take(rate);
        deviceLink.reportAlive();
        deviceLink.eventCounter().increment(LINE);
      } else if (message instanceof Malformed malformed) {
        log.debug("{}: a line contains no rate: {}", path(), malformed.line());
      }
    }

    private void take(Rate reported) {
      lastWasValid = reported.isValid();
      if (!reported.isValid()) {
        valid = 0;
        latest().markLost("the gyro says that its rate is not valid");
        return;
      }
      double left =
          Math.toRadians(inverted ? reported.degreesPerSecond() : -reported.degreesPerSecond());
      measure(left);
      if (++valid < TRUSTED) {
        return;
      }
      AngularRate rate = new AngularRate(clock().instant(), frame(), left - bias);
      latest().set(rate);
      publish(rate);
    }

    private void measure(double left) {
      StationaryBiasEstimator mean = measuring;
      if (mean != null && mean.add(left)) {
        measuring = null;
        deviceLink.eventCounter().increment(MEAN);
      }
    }

    @Override
    public void lost(String reason) {
      latest().markLost(reason);
    }
  }
}

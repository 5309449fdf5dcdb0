package org.dfra.drivers.gyro.kvh;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Malformed;
import org.dfra.drivers.gyro.kvh.Dsp3000Message.Rate;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The fibre-optic rate gyro KVH DSP-3000 on its serial line: 38400 8N1, 100 lines a second.
 *
 * <p>The gyro says that clockwise is +; what is told here is to the left +, radians per second,
 * less the bias.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}, {@code reopen_first}, {@code reopen_longest}: see {@link
 *       org.dfra.drivers.link.LinkSettings}; the link is required
 *   <li>{@code inverted}: {@code true} where it is mounted upside down; default {@code false}; can
 *       be set while it runs
 *   <li>{@code bias}: what it tells while it stands, radians per second, left is +, −{@value
 *       #MOST_BIAS} to {@value #MOST_BIAS}; default 0; can be set while it runs, and is by the
 *       recovery {@code zero_while_standing}
 *   <li>{@code mount_frame} and so on: see {@link org.dfra.core.module.DeviceImpl}
 *   <li>to be read only: {@code frames}, {@code dropped_bytes}, {@code malformed_frames}
 * </ul>
 *
 * <p>INITIALIZING until {@value #TRUSTED} lines in a row were valid; again when the link is lost,
 * when no line came for 2 s, or as soon as the gyro says that its rate is not valid. A rate is
 * served for 0.5 s.
 *
 * <p>Tests: {@code link}, {@code readings} (lines come), {@code validity} (the next line is valid).
 * Recoveries: {@code reopen_link}; {@code zero_while_standing}: takes the mean of 5 s for the bias,
 * and refuses it where the gyro visibly turns. Whoever asks for it vouches that the robot stands.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@code start} to {@code close}.
 */
public final class Dsp3000Impl extends SensorImpl implements AngularRateSensor {

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

  private final LatestReading<AngularRate> latest;
  private final DeviceLine line;

  private volatile boolean inverted;
  private volatile double bias;
  private volatile boolean lastWasValid;
  private volatile @Nullable StandingMean measuring; // null: nobody wants the bias

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public Dsp3000Impl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: by another time, and over links made in another way. */
  Dsp3000Impl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "fibre-optic rate gyro, KVH DSP-3000",
        "DFRA",
        "1.0",
        List.of("AngularRate"),
        PRECONDITIONS);
    this.latest = new LatestReading<>("rate", this, this::become, ticker::nanos, () -> OLDEST);
    this.inverted = invertedIn(settings().find("inverted").orElse("false"));
    this.bias = settings().number("bias", 0, -MOST_BIAS, MOST_BIAS);
    this.line = new DeviceLine(context, new Gyro(), ticker, source, log);
    this.line.declareIn(examinations(), declared());
    examinations().test("validity", this::validity);
    examinations().recovery("zero_while_standing", this::zero);
    declared()
        .text(
            "inverted",
            "whether it is mounted upside down, true or false",
            () -> Boolean.toString(inverted),
            text -> inverted = truth(text));
    declared()
        .number(
            "bias",
            "what it tells while it stands, to the left +",
            ParameterTable.Range.of(-MOST_BIAS, MOST_BIAS, "rad/s"),
            () -> bias,
            value -> bias = value);
  }

  private boolean invertedIn(String text) {
    try {
      return truth(text);
    } catch (IllegalArgumentException e) {
      throw settings().fault("inverted", String.valueOf(e.getMessage()), e);
    }
  }

  private static boolean truth(String text) {
    if (!text.equals("true") && !text.equals("false")) {
      throw new IllegalArgumentException("true or false");
    }
    return text.equals("true");
  }

  @Override
  protected void onStart() {
    latest.awaits("its link is being opened");
    line.start();
  }

  @Override
  protected void onClose() {
    line.close();
    latest.forget("it has ended");
  }

  @Override
  public double updateRate() {
    return HERTZ;
  }

  @Override
  public AngularRate rate() {
    return latest.get();
  }

  @Override
  protected List<? extends Attributes> traits() {
    return List.of(
        new SensorAttributes(
            "AngularRate",
            List.of("rate"),
            HERTZ,
            HERTZ,
            null,
            List.of("It turns no faster than 375°/s.")));
  }

  private Finding validity() throws InterruptedException {
    Finding link = line.link();
    if (!link.passed()) {
      return link;
    }
    if (!line.heard().await(LINE, line.heard().sofar(LINE), NEXT)) {
      return new Finding(false, "no line has come within " + LatestReading.seconds(NEXT));
    }
    return lastWasValid
        ? new Finding(true, "the gyro vouches for its rate")
        : new Finding(false, "the gyro says that its rate is not valid: it starts, or is broken");
  }

  private Finding zero() throws InterruptedException {
    if (!readiness().serves()) {
      return new Finding(false, "it tells no valid rate: " + latest.awaits());
    }
    StandingMean mean = new StandingMean();
    long before = line.heard().sofar(MEAN);
    measuring = mean;
    boolean done = line.heard().await(MEAN, before, MEASURING);
    measuring = null;
    if (!done) {
      return new Finding(
          false,
          "it has not told "
              + StandingMean.READINGS
              + " valid rates within "
              + LatestReading.seconds(MEASURING));
    }
    Finding finding = mean.finding();
    if (finding.passed()) {
      bias = mean.bias();
    }
    return finding;
  }

  /** What is done with the line; on the reader's thread. */
  private final class Gyro implements DeviceProtocol {

    /** Rate mode; told thrice, since the gyro misses a letter now and then. */
    private static final String RATE_MODE = "RRR";

    private static final Duration SILENCE = Duration.ofSeconds(2);

    private final Dsp3000Parser parser = new Dsp3000Parser(this::heard);
    private int valid; // lines in a row

    @Override
    public void opened(SerialLink link) throws IOException {
      valid = 0;
      latest.awaits(link + " is open, no line has come yet");
      link.write(RATE_MODE.getBytes(StandardCharsets.US_ASCII));
    }

    @Override
    public Dsp3000Parser parser() {
      return parser;
    }

    @Override
    public Duration longestSilence() {
      return SILENCE;
    }

    @Override
    public String expected() {
      return "line";
    }

    private void heard(Dsp3000Message message) {
      if (message instanceof Rate rate) {
        take(rate);
        line.alive();
        line.heard().count(LINE);
      } else if (message instanceof Malformed malformed) {
        log.debug("{}: a line tells no rate: {}", path(), malformed.line());
      }
    }

    private void take(Rate told) {
      lastWasValid = told.isValid();
      if (!told.isValid()) {
        valid = 0;
        latest.lose("the gyro says that its rate is not valid");
        return;
      }
      double left = Math.toRadians(inverted ? told.degreesPerSecond() : -told.degreesPerSecond());
      measure(left);
      if (++valid < TRUSTED) {
        return;
      }
      AngularRate rate = new AngularRate(clock().instant(), frame(), left - bias);
      latest.set(rate);
      tell(rate);
    }

    private void measure(double left) {
      StandingMean mean = measuring;
      if (mean != null && mean.take(left)) {
        measuring = null;
        line.heard().count(MEAN);
      }
    }

    @Override
    public void lost(String reason) {
      latest.lose(reason);
    }
  }
}

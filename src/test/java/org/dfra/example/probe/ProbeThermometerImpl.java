package org.dfra.example.probe;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.link.EventCounter;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkHandler;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.example.thermometer.TemperatureReading;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.jspecify.annotations.Nullable;

/**
 * A temperature probe on a serial line. Parameters: {@code link}, {@code reopen_initial_delay} and
 * {@code reopen_max_delay} as {@link LinkSettings}; {@code period} and {@code idle_period}, seconds
 * from one reading to the next, 1 to 60, with clients and when the last has gone, default 1 and 10.
 *
 * <p>Threads: one reader, owned by a {@link LinkKeeper}; askers see what it wrote last.
 */
public final class ProbeThermometerImpl extends SensorImpl implements Thermometer {

  private static final Precondition AIR = new Precondition("temperature", -55, 125, "°C");

  private final Ticker ticker;
  private final EventCounter received;
  private final LinkKeeper keeper;
  private final ProbePeriod pace;

  // written by the reader, read by anyone
  private volatile @Nullable TemperatureReading latest; // null: none to be served
  private volatile StreamCounts counts = StreamCounts.ZERO;
  private volatile String awaits = "it has not been started";

  /** Called by the module's server. */
  public ProbeThermometerImpl(ModuleContext context) {
    super(context, "Probe", "you", "1.0", List.of("TemperatureReading"), List.of(AIR));
    pace = new ProbePeriod(settings());
    ticker = Ticker.of(clock());
    received = new EventCounter(ticker);
    LinkAddress address = LinkSettings.address(settings());
    keeper =
        new LinkKeeper(
            context.name(),
            () -> address.open(ticker),
            new Reader(),
            LinkSettings.backOff(settings()),
            ticker,
            log);
    pace.declareIn(parameterTable());
    parameterTable()
        .declareReadOnly("dropped_bytes", "bytes of no line", () -> "" + counts.droppedBytes());
    parameterTable()
        .declareReadOnly("malformed", "lines of no temperature", () -> "" + counts.malformed());
    new ProbeDiagnostics(keeper, received, pace).declareIn(diagnostics());
  }

  @Override
  protected void onStart() {
    awaits = "its link is being opened";
    keeper.start();
  }

  @Override
  protected void onClose() {
    keeper.close(); // the reader has ended
    latest = null;
    awaits = "it has ended";
  }

  @Override
  protected void onClientCount(int number) {
    pace.setIdle(number == 0); // the reader sends it to the probe
  }

  @Override
  public double updateRate() {
    return 1 / pace.seconds();
  }

  @Override
  public double celsius() {
    TemperatureReading last = latest;
    if (last == null) {
      throw new NotReadyException(path(), readiness(), awaits);
    }
    return last.celsius();
  }

  /** What is done with the link; on the reader's thread, so nothing here may block. */
  private final class Reader implements LinkHandler {

    private final ProbeParser parser = new ProbeParser(this::take);
    private double ordered; // seconds that the probe was last set to; 0: none yet
    private long patientSince;

    @Override
    public void opened(SerialLink link) {
      awaits = link + " is open, no temperature has come yet";
      ordered = 0; // it may have been switched off meanwhile, or be another one
      received.increment(ProbeDiagnostics.OPENING);
    }

    @Override
    public boolean received(byte[] bytes, int length) {
      long before = counts.frames();
      parser.feed(bytes, 0, length);
      counts = parser.counts();
      return counts.frames() > before;
    }

    @Override
    public @Nullable String periodic(SerialLink link) throws IOException {
      double wanted = pace.seconds(); // once: others may change it meanwhile
      if (ordered != wanted) {
        ordered = wanted;
        link.write(ProbeParser.order(ordered));
        patientSince = ticker.nanos();
      }
      Duration patience = ProbePeriod.patience(ordered);
      boolean lost = ticker.nanos() - patientSince > patience.toNanos();
      return lost ? "no temperature for " + ProbePeriod.inWords(patience) : null;
    }

    @Override
    public void lost(String reason) {
      parser.finish(); // what comes next is another stream
      counts = parser.counts();
      awaits = reason;
      latest = null;
      if (readiness().serves()) {
        transitionTo(Readiness.INITIALIZING, reason); // enters the history as a failure
      }
    }

    private void take(double celsius) {
      if (Double.isNaN(celsius)) {
        log.debug("an intact line tells no temperature from -55 to 125 °C");
        return;
      }
      patientSince = ticker.nanos();
      TemperatureReading reading = new TemperatureReading(celsius, clock().instant());
      latest = reading;
      received.increment(ProbeDiagnostics.READING);
      if (readiness() == Readiness.INITIALIZING) {
        transitionTo(Readiness.READY);
      }
      publish(reading);
    }
  }
}

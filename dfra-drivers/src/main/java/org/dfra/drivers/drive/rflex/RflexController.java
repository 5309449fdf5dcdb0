package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.function.Function;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.SharedLine;
import org.dfra.drivers.device.SharedLines;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.SerialAddress;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * An rFLEX controller, shared by the modules of a virtual machine that name the same link, as a
 * {@link SharedLine}.
 *
 * <p>It has the controller report both axes as often as the most curious member wants, and asks for
 * battery and brake likewise. A controller that reports nothing for {@link #LOST_AFTER} is lost,
 * and its link opened anew.
 *
 * <p>Threads: one reader ({@code rflex reader}) and one writer ({@code rflex writer}, see {@link
 * RflexOutbox}), from the first module to the last.
 */
final class RflexController extends SharedLine<RflexMember> {

  /** After so long without a report. */
  static final Duration LOST_AFTER = Duration.ofSeconds(1);

  /** What is counted for a report of each axis, and for a status. */
  static final String REPORT = "report";

  static final String STATUS = "status";

  /** A request may be lost on the way. */
  private static final Duration ASK_AGAIN = Duration.ofMillis(500);

  /** A link that is lost so soon after it was opened was perhaps taken by somebody else. */
  private static final Duration SOON = Duration.ofSeconds(3);

  private static final String HINT =
      " (if another process has it: modules that share a controller must be in one group)";

  private static final SharedLines<RflexMember, RflexController> LINES = new SharedLines<>();

  private final LinkAddress address;
  private final Ticker ticker;
  private final DeviceLine line;
  private final RflexOutbox outbox;
  private final RflexParser parser = new RflexParser(this::heard);

  // confined to the reader
  private @Nullable Duration requested; // how often it is to report; null before it was told
  private long requestedNanos;
  private long reportedNanos;
  private long askedNanos; // for the last status
  private boolean wasOpen;
  private long openedNanos;

  private RflexController(
      LinkAddress address,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(LINES, "rflex", context);
    this.address = address;
    this.ticker = ticker;
    this.line = lineFor(new Protocol(), ticker, source);
    this.outbox = new RflexOutbox("rflex", ticker, this::write);
  }

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if others name the same port in another way
   */
  static RflexController join(
      RflexMember member,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    LinkAddress address = LinkSettings.address(context.parameters());
    return LINES.join(
        member,
        place(address),
        ticker,
        () -> new RflexController(address, context, ticker, source),
        found -> found.agree(address, context));
  }

  private void agree(LinkAddress wanted, ModuleContext context) {
    if (!address.equals(wanted)) {
      throw context
          .parameters()
          .fault("link", "\"" + address + "\" as " + first() + " has it", null);
    }
  }

  /** A serial port is one, however its line is set. */
  private static String place(LinkAddress address) {
    return address instanceof SerialAddress serial ? "serial:" + serial.port() : address.toString();
  }

  @Override
  protected void start() {
    outbox.start();
    super.start();
  }

  @Override
  protected void close() {
    outbox.close(); // a halt may be on its way
    super.close();
  }

  @Override
  public DeviceLine line() {
    return line;
  }

  /** Where the controller is told something. */
  RflexOutbox outbox() {
    return outbox;
  }

  private void write(byte[] frame) {
    boolean unused = line.sendNow(frame); // where there is no link, nobody is told later
  }

  private void heard(RflexMessage message) {
    if (message instanceof MotorReport) {
      reportedNanos = ticker.nanos();
      line.alive();
      line.heard().count(REPORT);
    } else if (message instanceof RflexMessage.SystemStatus) {
      line.heard().count(STATUS);
    }
    members().greet(RflexMember::opened);
    members().tell(member -> member.heard(message));
  }

  /** What the most curious member wants. */
  private Duration shortest(Function<RflexMember, Duration> wanted, Duration fallback) {
    return members().ask(all -> all.stream().map(wanted).min(Duration::compareTo).orElse(fallback));
  }

  /** What happens on the link; on the reader thread. */
  private final class Protocol implements DeviceProtocol {

    @Override
    public void opened(SerialLink link) {
      outbox.clear();
      requested = null;
      wasOpen = true;
      openedNanos = ticker.nanos();
      askedNanos = openedNanos - Duration.ofHours(1).toNanos();
    }

    @Override
    public RflexParser parser() {
      return parser;
    }

    @Override
    public void tend(SerialLink link) {
      members().greet(RflexMember::opened);
      Duration reports = shortest(RflexMember::reports, RflexMember.USUAL_REPORTS);
      Duration status = shortest(RflexMember::status, RflexMember.USUAL_STATUS);
      long now = ticker.nanos();
      boolean isSilent =
          Math.min(now - reportedNanos, now - requestedNanos)
              > Math.max(ASK_AGAIN.toNanos(), 3 * reports.toNanos());
      if (!reports.equals(requested) || isSilent) {
        requested = reports;
        requestedNanos = now;
        outbox.add(RflexCommands.reports(reports.toNanos() / 1000));
      }
      if (now - askedNanos >= status.toNanos()) {
        askedNanos = now;
        outbox.add(RflexCommands.status());
      }
    }

    @Override
    public Duration longestSilence() {
      return LOST_AFTER;
    }

    @Override
    public String expected() {
      return "report of an rFLEX controller";
    }

    @Override
    public void lost(String reason) {
      outbox.clear();
      boolean isSoon = !wasOpen || ticker.nanos() - openedNanos < SOON.toNanos();
      wasOpen = false;
      members().lose(isSoon ? reason + HINT : reason);
    }
  }
}

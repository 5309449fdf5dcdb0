package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.function.Function;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.SharedDeviceLink;
import org.dfra.drivers.device.SharedLinkRegistry;
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
 * {@link SharedDeviceLink}.
 *
 * <p>It has the controller report both axes as often as the most curious member wants, and asks for
 * battery and brake likewise. A controller that reports nothing for {@link #LOST_AFTER} is lost,
 * and its link opened anew.
 *
 * <p>Threads: one reader ({@code rflex reader}) and one writer ({@code rflex writer}, see {@link
 * RflexOutbox}), from the first module to the last.
 */
final class RflexController extends SharedDeviceLink<RflexClient> {

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

  private static final SharedLinkRegistry<RflexClient, RflexController> LINES =
      new SharedLinkRegistry<>();

  private final LinkAddress address;
  private final Ticker ticker;
  private final DeviceLink deviceLink;
  private final RflexOutbox outbox;
  private final RflexParser parser = new RflexParser(this::messageReceived);

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
    this.deviceLink = newDeviceLink(new Protocol(), ticker, source);
    this.outbox = new RflexOutbox("rflex", ticker, this::write);
  }

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if others name the same port in another way
   */
  static RflexController join(
      RflexClient client,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    LinkAddress address = LinkSettings.address(context.parameters());
    return LINES.join(
        client,
        linkKey(address),
        ticker,
        () -> new RflexController(address, context, ticker, source),
        found -> found.requireSameAddress(address, context));
  }

  private void requireSameAddress(LinkAddress desired, ModuleContext context) {
    if (!address.equals(desired)) {
      throw context
          .parameters()
          .fault("link", "\"" + address + "\" as " + firstClientPath() + " has it", null);
    }
  }

  /** A serial port is one, however its line is set. */
  private static String linkKey(LinkAddress address) {
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
  public DeviceLink deviceLink() {
    return deviceLink;
  }

  /** Where the controller is told something. */
  RflexOutbox outbox() {
    return outbox;
  }

  private void write(byte[] frame) {
    boolean unused = deviceLink.sendNow(frame); // where there is no link, nobody is told later
  }

  private void messageReceived(RflexMessage message) {
    if (message instanceof MotorReport) {
      reportedNanos = ticker.nanos();
      deviceLink.reportAlive();
      deviceLink.eventCounter().increment(REPORT);
    } else if (message instanceof RflexMessage.SystemStatus) {
      deviceLink.eventCounter().increment(STATUS);
    }
    clients().notifyConnected(RflexClient::opened);
    clients().dispatch(client -> client.messageReceived(message));
  }

  /** What the most curious member wants. */
  private Duration shortest(Function<RflexClient, Duration> desired, Duration fallback) {
    return clients()
        .query(all -> all.stream().map(desired).min(Duration::compareTo).orElse(fallback));
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
    public void periodic(SerialLink link) {
      clients().notifyConnected(RflexClient::opened);
      Duration reports = shortest(RflexClient::reports, RflexClient.USUAL_REPORTS);
      Duration status = shortest(RflexClient::status, RflexClient.USUAL_STATUS);
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
    public Duration livenessTimeout() {
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
      clients().notifyLost(isSoon ? reason + HINT : reason);
    }
  }
}

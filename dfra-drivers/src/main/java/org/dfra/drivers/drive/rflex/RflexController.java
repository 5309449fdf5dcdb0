package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.function.Function;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.SharedDeviceLink;
import org.dfra.drivers.device.SharedLinkClient;
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
 * <p>It requests reports of both axes, and of battery and brake, with the shortest period that a
 * client requires. A controller that reports nothing for {@link #LOST_AFTER} counts as lost, and
 * its link is reopened.
 *
 * <p>Threads: one reader ({@code rflex reader}) and one writer ({@code rflex writer}, see {@link
 * RflexOutbox}), from the first module to the last.
 */
final class RflexController extends SharedDeviceLink<RflexController.RflexClient> {

  /** Time without a report after which the controller counts as lost. */
  static final Duration LOST_AFTER = Duration.ofSeconds(1);

  /** Events that are counted: a report of both axes, and a status. */
  static final String REPORT = "report";

  static final String STATUS = "status";

  /** Time after which a request without an answer is repeated. */
  private static final Duration ASK_AGAIN = Duration.ofMillis(500);

  /** A link that is lost so soon after opening may be in use by another program. */
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
  private @Nullable Duration requested; // requested report period; null before the first request
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
   * @param source opens the link; null to use the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if other modules open the same port with
   *     other settings
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

  /** A serial port is the same link, whatever its line settings are. */
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
    outbox.close(); // a halt may be pending
    super.close();
  }

  @Override
  public DeviceLink deviceLink() {
    return deviceLink;
  }

  /** The queue of frames to the controller. */
  RflexOutbox outbox() {
    return outbox;
  }

  private void write(byte[] frame) {
    boolean unused = deviceLink.sendNow(frame); // without a link, the frame is dropped
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

  /** The shortest period that a client requires. */
  private Duration shortest(Function<RflexClient, Duration> desired, Duration fallback) {
    return clients()
        .query(all -> all.stream().map(desired).min(Duration::compareTo).orElse(fallback));
  }

  /** Handles the link; on the reader thread. */
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

  /** A module that shares an {@link RflexController}. */
  interface RflexClient extends SharedLinkClient {

    /** Default period of axis reports. */
    Duration USUAL_REPORTS = Duration.ofMillis(100);

    /** Default period of battery and brake reports. */
    Duration USUAL_STATUS = Duration.ofSeconds(1);

    /** Required period of axis reports; queried repeatedly. */
    default Duration reports() {
      return USUAL_REPORTS;
    }

    /** Required period of battery and brake reports; queried repeatedly. */
    default Duration status() {
      return USUAL_STATUS;
    }

    /** The link is open; from now on messages are received and commands can be sent. */
    void opened();

    /** The controller has sent this message. */
    void messageReceived(RflexMessage message);
  }
}

package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.SharedDeviceLink;
import org.dfra.drivers.device.SharedLinkClient;
import org.dfra.drivers.device.SharedLinkRegistry;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.dfra.drivers.uav.mavlink.MavlinkLinkHandle.MavlinkSettings;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Heartbeat;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFrame;
import org.jspecify.annotations.Nullable;

/**
 * A link to a vehicle, shared by the modules of a virtual machine that name the same one, as a
 * {@link SharedDeviceLink}.
 *
 * <p>The vehicle is the first autopilot received, or the one of the parameter {@code vehicle};
 * other vehicles on the link, cameras and gimbals are ignored. The vehicle is lost when no {@code
 * HEARTBEAT} has been received for 3 s; then the link is reopened. The driver sends its own
 * heartbeat once a second while one of the modules commands the vehicle: an autopilot's failsafe
 * acts when heartbeats of its ground station are missing, and modules that only receive must not
 * prevent that.
 *
 * <p>Threads: one reader ({@code mavlink reader}), owned from the first module to the last.
 */
final class MavlinkConnection extends SharedDeviceLink<MavlinkConnection.MavlinkClient> {

  /** Time without a heartbeat after which a vehicle counts as lost. */
  static final Duration LOST_AFTER = Duration.ofSeconds(3);

  private static final Duration HEARTBEAT_EVERY = Duration.ofSeconds(1);

  private static final SharedLinkRegistry<MavlinkClient, MavlinkConnection> LINES =
      new SharedLinkRegistry<>();

  private final MavlinkSettings settings;
  private final Ticker ticker;
  private final MavlinkEncoder encoder;
  private final DeviceLink deviceLink;
  private final CommandProtocol commands;
  private final MessageIntervalRequester streams; // confined to the reader
  private final MavlinkParser parser = new MavlinkParser(this::frameReceived);

  private volatile @Nullable Vehicle vehicle; // written by the reader
  private volatile @Nullable String software; // written by the reader
  private volatile long lostFrames; // written by the reader
  private int sequence = -1; // confined to the reader
  private long heartbeatNanos; // confined to the reader

  private MavlinkConnection(
      ModuleContext context,
      MavlinkSettings settings,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(LINES, "mavlink", context);
    this.settings = settings;
    this.ticker = ticker;
    this.encoder = new MavlinkEncoder(settings.groundStation());
    this.deviceLink = newDeviceLink(new Protocol(), ticker, source);
    this.commands = new CommandProtocol(ticker, this::send);
    this.streams = new MessageIntervalRequester(commands, ticker, log);
  }

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param source opens the link; null to use the parameter {@code link}
   * @throws IllegalStateException if the other modules have other settings
   */
  static MavlinkConnection join(
      MavlinkClient client,
      ModuleContext context,
      MavlinkSettings settings,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    return LINES.join(
        client,
        settings.link(),
        ticker,
        () -> new MavlinkConnection(context, settings, ticker, source),
        found -> found.requireSameSettings(settings, client));
  }

  private void requireSameSettings(MavlinkSettings wanted, MavlinkClient client) {
    if (!settings.equals(wanted)) {
      throw new IllegalStateException(
          client.path()
              + " shares its link with "
              + firstClientPath()
              + ", but not its settings: "
              + wanted
              + " here, "
              + settings
              + " there; write the same in both");
    }
  }

  @Override
  public DeviceLink deviceLink() {
    return deviceLink;
  }

  /** The command protocol of the vehicle. */
  CommandProtocol commands() {
    return commands;
  }

  /** The vehicle on the link; null while there is none. */
  @Nullable Vehicle vehicle() {
    return vehicle;
  }

  /** The version of its software; null until reported. */
  @Nullable String software() {
    return software;
  }

  /** Number of the vehicle's frames that were lost or unknown, from the sequence numbers. */
  long lostFrames() {
    return lostFrames;
  }

  /** See {@link MavlinkParser.MavlinkFramer#checksumErrors}. */
  long checksumErrors() {
    return parser.checksumErrors();
  }

  /** Requests the autopilot's version. */
  void askForVersion() {
    CommandProtocol.@Nullable Exchange unused =
        commands.submit(
            MavlinkCommand.CommandLong.of(
                MavCmd.MAV_CMD_REQUEST_MESSAGE, MessageIds.AUTOPILOT_VERSION, 0),
            result -> {});
  }

  /**
   * Sends a command once, bypassing pending commands, without waiting for an answer; from any
   * thread.
   */
  void sendNow(MavlinkCommand command) {
    send(command, 0);
  }

  private void send(MavlinkCommand command, int times) {
    @Nullable Vehicle to = vehicle;
    if (to != null) {
      boolean unused =
          deviceLink.sendNow(encoder.command(to, command, times)); // resent if it is lost
    }
  }

  private void frameReceived(MavlinkFrame frame) {
    if (frame.message() instanceof Heartbeat heartbeat
        && heartbeat.autopilot() != Vehicle.NO_AUTOPILOT
        && (settings.vehicle() == 0 || settings.vehicle() == frame.system())) {
      heartbeatReceived(frame, heartbeat);
    }
    @Nullable Vehicle known = vehicle;
    if (known == null
        || known.system() != frame.system()
        || known.component() != frame.component()) {
      return;
    }
    if (sequence >= 0) {
      lostFrames += frame.missingSince(sequence);
    }
    sequence = frame.sequence();
    take(known, frame.message());
  }

  private void heartbeatReceived(MavlinkFrame frame, Heartbeat heartbeat) {
    @Nullable Vehicle known = vehicle;
    Vehicle reported =
        new Vehicle(frame.system(), frame.component(), heartbeat.type(), heartbeat.autopilot());
    if (known == null) {
      log.info("found {}", reported);
      vehicle = reported;
      sequence = -1;
      commands.open();
      askForVersion();
    } else if (known.system() != frame.system() || known.component() != frame.component()) {
      return;
    }
    deviceLink.reportAlive();
  }

  private void take(Vehicle from, MavlinkMessage message) {
    if (message instanceof CommandAck ack) {
      boolean ours =
          (ack.targetSystem() == 0 || ack.targetSystem() == settings.groundStation())
              && (ack.targetComponent() == 0 || ack.targetComponent() == MavlinkEncoder.COMPONENT);
      if (ours) {
        commands.acknowledge(ack);
      }
    } else if (message instanceof MavlinkMessage.Version version) {
      software = version.software();
    }
    streams.messageReceived(message);
    notifyConnected(from);
    clients().dispatch(client -> client.messageReceived(message));
    deviceLink.eventCounter().increment(message.name());
  }

  /** Notifies the clients that have joined since that there is a vehicle. */
  private void notifyConnected(Vehicle found) {
    clients().notifyConnected(client -> client.vehicleFound(found));
  }

  /** Whether one of the modules commands the vehicle. */
  private boolean commanded() {
    return clients().query(all -> all.stream().anyMatch(MavlinkClient::commands));
  }

  /** All messages required by clients, each at the highest required rate. */
  private Map<Integer, Double> requestedRates() {
    Map<Integer, Double> wanted = new HashMap<>();
    clients()
        .query(all -> all.stream().map(MavlinkClient::messageRates).toList())
        .forEach(each -> each.forEach((id, rate) -> wanted.merge(id, rate, Math::max)));
    return wanted;
  }

  /** Handles the link; on the reader thread. */
  private final class Protocol implements DeviceProtocol {

    @Override
    public void opened(SerialLink link) {
      vehicle = null;
      streams.forget();
      heartbeatNanos = ticker.nanos() - HEARTBEAT_EVERY.toNanos();
    }

    @Override
    public MavlinkParser parser() {
      return parser;
    }

    @Override
    public void periodic(SerialLink link) throws IOException {
      @Nullable Vehicle known = vehicle;
      if (known != null) {
        notifyConnected(known);
      }
      clients().dispatch(MavlinkClient::periodic);
      long now = ticker.nanos();
      if (now - heartbeatNanos >= HEARTBEAT_EVERY.toNanos() && commanded()) {
        heartbeatNanos = now;
        link.write(encoder.heartbeat());
      }
      if (known != null && commands.resendDue()) {
        streams.requestDue(requestedRates());
      }
    }

    @Override
    public Duration livenessTimeout() {
      return LOST_AFTER;
    }

    @Override
    public String expected() {
      return settings.vehicle() == 0
          ? "HEARTBEAT of an autopilot"
          : "HEARTBEAT of vehicle " + settings.vehicle();
    }

    @Override
    public void lost(String reason) {
      vehicle = null;
      commands.lost();
      clients().notifyLost(reason);
    }
  }

  /** A module that shares a {@link MavlinkConnection}. */
  interface MavlinkClient extends SharedLinkClient {

    /** Whether it commands the vehicle, which then requires heartbeats. */
    default boolean commands() {
      return false;
    }

    /**
     * The required messages, with their rates in hertz; queried repeatedly, so that a rate can
     * change.
     */
    Map<Integer, Double> messageRates();

    /** The link is open, and this vehicle is on it; from now on its messages are received. */
    void vehicleFound(Vehicle vehicle);

    /** The vehicle's autopilot has sent this message. */
    void messageReceived(MavlinkMessage message);

    /** Called periodically, at intervals of at most some tenths of a second. */
    void periodic();
  }
}

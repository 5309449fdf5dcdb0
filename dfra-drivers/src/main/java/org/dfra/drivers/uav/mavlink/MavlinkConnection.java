package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.device.DeviceProtocol;
import org.dfra.drivers.device.SharedLine;
import org.dfra.drivers.device.SharedLines;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Heartbeat;
import org.jspecify.annotations.Nullable;

/**
 * A link to a vehicle, shared by the modules of a virtual machine that name the same one, as a
 * {@link SharedLine}.
 *
 * <p>The vehicle is the first autopilot heard, or the one of the parameter {@code vehicle}; all
 * others on the link, its cameras and its gimbals are passed over. It is lost when its {@code
 * HEARTBEAT} has not come for 3 s; then the link is opened anew. Ours is sent once a second while
 * one of the modules commands the vehicle: an autopilot acts when it misses the ground station that
 * commands it, and none that only listens must keep it from that.
 *
 * <p>Threads: one reader ({@code mavlink reader}), owned from the first module to the last.
 */
final class MavlinkConnection extends SharedLine<MavlinkMember> {

  /** After so long without a heartbeat a vehicle is lost. */
  static final Duration LOST_AFTER = Duration.ofSeconds(3);

  private static final Duration HEARTBEAT_EVERY = Duration.ofSeconds(1);

  private static final SharedLines<MavlinkMember, MavlinkConnection> LINES = new SharedLines<>();

  private final MavlinkSettings settings;
  private final Ticker ticker;
  private final MavlinkEncoder encoder;
  private final DeviceLine line;
  private final CommandProtocol commands;
  private final MavlinkStreams streams; // confined to the reader
  private final MavlinkParser parser = new MavlinkParser(this::heard);

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
    this.line = lineFor(new Protocol(), ticker, source);
    this.commands = new CommandProtocol(ticker, this::send);
    this.streams = new MavlinkStreams(commands, ticker, log);
  }

  /**
   * Joins the modules of a link; opens it for the first.
   *
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws IllegalStateException if the others have other settings
   */
  static MavlinkConnection join(
      MavlinkMember member,
      ModuleContext context,
      MavlinkSettings settings,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    return LINES.join(
        member,
        settings.link(),
        ticker,
        () -> new MavlinkConnection(context, settings, ticker, source),
        found -> found.agree(settings, member));
  }

  private void agree(MavlinkSettings wanted, MavlinkMember member) {
    if (!settings.equals(wanted)) {
      throw new IllegalStateException(
          member.path()
              + " shares its link with "
              + first()
              + ", but not its settings: "
              + wanted
              + " here, "
              + settings
              + " there; write the same in both");
    }
  }

  @Override
  public DeviceLine line() {
    return line;
  }

  /** Where commands are sent. */
  CommandProtocol commands() {
    return commands;
  }

  /** The vehicle on the link; null while there is none. */
  @Nullable Vehicle vehicle() {
    return vehicle;
  }

  /** The version of its software; null while it has not told. */
  @Nullable String software() {
    return software;
  }

  /** Frames of the vehicle that did not arrive, or were not known, by their numbers. */
  long lostFrames() {
    return lostFrames;
  }

  /** See {@link MavlinkFramer#checksumErrors}. */
  long checksumErrors() {
    return parser.checksumErrors();
  }

  /** Has the autopilot tell what it is. */
  void askForVersion() {
    CommandProtocol.@Nullable Exchange unused =
        commands.begin(
            MavlinkCommand.Plain.of(
                MavCmd.MAV_CMD_REQUEST_MESSAGE, MessageIds.AUTOPILOT_VERSION, 0),
            result -> {});
  }

  /** Sends a command once, past whatever is under way, and awaits no answer; from any thread. */
  void sendNow(MavlinkCommand command) {
    send(command, 0);
  }

  private void send(MavlinkCommand command, int times) {
    @Nullable Vehicle to = vehicle;
    if (to != null) {
      boolean unused =
          line.sendNow(encoder.command(to, command, times)); // sent again if it is lost
    }
  }

  private void heard(MavlinkFrame frame) {
    if (frame.message() instanceof Heartbeat heartbeat
        && heartbeat.autopilot() != Vehicle.NO_AUTOPILOT
        && (settings.vehicle() == 0 || settings.vehicle() == frame.system())) {
      lives(frame, heartbeat);
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

  private void lives(MavlinkFrame frame, Heartbeat heartbeat) {
    @Nullable Vehicle known = vehicle;
    Vehicle told =
        new Vehicle(frame.system(), frame.component(), heartbeat.type(), heartbeat.autopilot());
    if (known == null) {
      log.info("found {}", told);
      vehicle = told;
      sequence = -1;
      commands.found();
      askForVersion();
    } else if (known.system() != frame.system() || known.component() != frame.component()) {
      return;
    }
    line.alive();
  }

  private void take(Vehicle from, MavlinkMessage message) {
    if (message instanceof CommandAck ack) {
      boolean ours =
          (ack.targetSystem() == 0 || ack.targetSystem() == settings.groundStation())
              && (ack.targetComponent() == 0 || ack.targetComponent() == MavlinkEncoder.COMPONENT);
      if (ours) {
        commands.heard(ack);
      }
    } else if (message instanceof MavlinkMessage.Version version) {
      software = version.software();
    }
    streams.heard(message);
    greet(from);
    members().tell(member -> member.heard(message));
    line.heard().count(message.name());
  }

  /** Tells those who have joined since that there is a vehicle. */
  private void greet(Vehicle found) {
    members().greet(member -> member.found(found));
  }

  /** Whether one of the modules commands the vehicle. */
  private boolean commanded() {
    return members().ask(all -> all.stream().anyMatch(MavlinkMember::commands));
  }

  /** The messages that any of them wants, as often as the one that wants them most often. */
  private Map<Integer, Double> wanted() {
    Map<Integer, Double> wanted = new HashMap<>();
    members()
        .ask(all -> all.stream().map(MavlinkMember::streams).toList())
        .forEach(each -> each.forEach((id, rate) -> wanted.merge(id, rate, Math::max)));
    return wanted;
  }

  /** What happens on the link; on the reader thread. */
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
    public void tend(SerialLink link) throws IOException {
      @Nullable Vehicle known = vehicle;
      if (known != null) {
        greet(known);
      }
      members().tell(MavlinkMember::tend);
      long now = ticker.nanos();
      if (now - heartbeatNanos >= HEARTBEAT_EVERY.toNanos() && commanded()) {
        heartbeatNanos = now;
        link.write(encoder.heartbeat());
      }
      if (known != null && commands.tend()) {
        streams.tend(wanted());
      }
    }

    @Override
    public Duration longestSilence() {
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
      members().lose(reason);
    }
  }
}

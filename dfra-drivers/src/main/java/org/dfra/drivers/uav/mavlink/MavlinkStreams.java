package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.dfra.drivers.link.Ticker;
import org.slf4j.Logger;

/**
 * Has the autopilot send what the modules want, as often as they want it ({@code
 * SET_MESSAGE_INTERVAL}), and asks again where it does not come: an autopilot that was restarted
 * has forgotten. Confined to the reader thread.
 */
final class MavlinkStreams {

  private static final Duration LOOK = Duration.ofMillis(200);
  private static final Duration SILENCE = Duration.ofSeconds(3);
  private static final Duration AGAIN = Duration.ofSeconds(5);

  /** What was asked for. */
  private static final class Stream {
    double rate;
    long askedNanos;
    long heardNanos;
    boolean asking;
    boolean refused;
  }

  private final CommandProtocol commands;
  private final Ticker ticker;
  private final Logger log;
  private final Map<Integer, Stream> streams = new HashMap<>();
  private long lookedNanos;

  MavlinkStreams(CommandProtocol commands, Ticker ticker, Logger log) {
    this.commands = commands;
    this.ticker = ticker;
    this.log = log;
    this.lookedNanos = ticker.nanos() - LOOK.toNanos();
  }

  /** Another vehicle, or the same after a while: it knows nothing yet. */
  void forget() {
    streams.clear();
    lookedNanos = ticker.nanos() - LOOK.toNanos();
  }

  /** A message has come. */
  void heard(MavlinkMessage message) {
    streams.forEach(
        (id, stream) -> {
          if (names(id).equals(message.name())) {
            stream.heardNanos = ticker.nanos();
          }
        });
  }

  /** Asks for what is due to be asked for. */
  void tend(Map<Integer, Double> wanted) {
    long now = ticker.nanos();
    if (now - lookedNanos < LOOK.toNanos()) {
      return;
    }
    lookedNanos = now;
    wanted.forEach((id, rate) -> tend(id, rate, now));
  }

  private void tend(int id, double rate, long now) {
    Stream stream = streams.get(id);
    if (stream == null || stream.rate != rate) {
      stream = new Stream();
      stream.rate = rate;
      streams.put(id, stream);
      ask(id, stream, now);
      return;
    }
    long longest = Math.max(SILENCE.toNanos(), (long) (5e9 / rate));
    if (!stream.asking
        && !stream.refused
        && now - stream.heardNanos > longest
        && now - stream.askedNanos > AGAIN.toNanos()) {
      ask(id, stream, now);
    }
  }

  private void ask(int id, Stream stream, long now) {
    stream.askedNanos = now;
    stream.heardNanos = now;
    MavlinkCommand request =
        MavlinkCommand.Plain.of(
            MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL, id, Math.round(1e6 / stream.rate));
    stream.asking = commands.begin(request, result -> answered(id, stream, result)) != null;
  }

  private void answered(int id, Stream stream, CommandResult result) {
    stream.asking = false;
    stream.refused = result.end() == CommandResult.End.REFUSED;
    if (stream.refused) {
      log.warn(
          "{} at {} Hz {}; set the autopilot's own rates up to send it",
          names(id),
          stream.rate,
          result);
    }
  }

  private static String names(int id) {
    return switch (id) {
      case MessageIds.SYS_STATUS -> "SYS_STATUS";
      case MessageIds.SYSTEM_TIME -> "SYSTEM_TIME";
      case MessageIds.GPS_RAW_INT -> "GPS_RAW_INT";
      case MessageIds.GLOBAL_POSITION_INT -> "GLOBAL_POSITION_INT";
      case MessageIds.VFR_HUD -> "VFR_HUD";
      case MessageIds.BATTERY_STATUS -> "BATTERY_STATUS";
      case MessageIds.EXTENDED_SYS_STATE -> "EXTENDED_SYS_STATE";
      default -> MavlinkCatalogue.name(id);
    };
  }
}

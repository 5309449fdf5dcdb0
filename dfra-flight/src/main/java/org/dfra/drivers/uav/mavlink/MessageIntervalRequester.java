package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.slf4j.Logger;

/**
 * Requests the messages that the modules require, at the required rates ({@code
 * SET_MESSAGE_INTERVAL}), and repeats the request if they do not arrive: an autopilot loses the
 * intervals when it restarts. Confined to the reader thread.
 */
final class MessageIntervalRequester {

  private static final Duration CHECK_INTERVAL = Duration.ofMillis(200);
  private static final Duration SILENCE = Duration.ofSeconds(3);
  private static final Duration AGAIN = Duration.ofSeconds(5);

  /** A requested message. */
  private static final class Stream {
    double rate;
    long askedNanos;
    long receivedNanos;
    boolean asking;
    boolean refused;
  }

  private final CommandProtocol commands;
  private final Ticker ticker;
  private final Logger log;
  private final Map<Integer, Stream> streams = new HashMap<>();
  private long checkedNanos;

  MessageIntervalRequester(CommandProtocol commands, Ticker ticker, Logger log) {
    this.commands = commands;
    this.ticker = ticker;
    this.log = log;
    this.checkedNanos = ticker.nanos() - CHECK_INTERVAL.toNanos();
  }

  /** Discards the requests: another vehicle, or the same after an interruption. */
  void forget() {
    streams.clear();
    checkedNanos = ticker.nanos() - CHECK_INTERVAL.toNanos();
  }

  /** A message has been received. */
  void messageReceived(MavlinkMessage message) {
    streams.forEach(
        (id, stream) -> {
          if (names(id).equals(message.name())) {
            stream.receivedNanos = ticker.nanos();
          }
        });
  }

  /** Sends the requests that are due. */
  void requestDue(Map<Integer, Double> requested) {
    long now = ticker.nanos();
    if (now - checkedNanos < CHECK_INTERVAL.toNanos()) {
      return;
    }
    checkedNanos = now;
    requested.forEach((id, rate) -> requestDue(id, rate, now));
  }

  private void requestDue(int id, double rate, long now) {
    Stream stream = streams.get(id);
    if (stream == null || stream.rate != rate) {
      stream = new Stream();
      stream.rate = rate;
      streams.put(id, stream);
      requestInterval(id, stream, now);
      return;
    }
    long longest = Math.max(SILENCE.toNanos(), (long) (5e9 / rate));
    if (!stream.asking
        && !stream.refused
        && now - stream.receivedNanos > longest
        && now - stream.askedNanos > AGAIN.toNanos()) {
      requestInterval(id, stream, now);
    }
  }

  private void requestInterval(int id, Stream stream, long now) {
    stream.askedNanos = now;
    stream.receivedNanos = now;
    MavlinkCommand request =
        MavlinkCommand.CommandLong.of(
            MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL, id, Math.round(1e6 / stream.rate));
    stream.asking = commands.submit(request, result -> answered(id, stream, result)) != null;
  }

  private void answered(int id, Stream stream, CommandResult result) {
    stream.asking = false;
    stream.refused = result.outcome() == CommandResult.CommandOutcome.REJECTED;
    if (stream.refused) {
      log.warn(
          "{} at {} Hz {}; configure the autopilot's own stream rates to send it",
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

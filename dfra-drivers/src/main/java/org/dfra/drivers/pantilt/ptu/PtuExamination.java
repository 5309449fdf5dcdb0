package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.jspecify.annotations.Nullable;

/** Tests and recoveries of the unit, besides those of its line. */
final class PtuExamination {

  private static final Duration ANSWER = Duration.ofSeconds(3);
  private static final Duration RESET = Duration.ofSeconds(60);

  private final DeviceLine line;
  private final PtuProtocol protocol;
  private final Supplier<@Nullable String> commander;
  private final BooleanSupplier stopped;
  private volatile PtuReply last = new PtuReply.Done(); // before its question was ever answered

  /**
   * @param commander who commands the unit, null while nobody does
   * @param stopped whether it is stopped for an emergency
   */
  PtuExamination(
      DeviceLine line,
      PtuProtocol protocol,
      Supplier<@Nullable String> commander,
      BooleanSupplier stopped) {
    this.line = line;
    this.protocol = protocol;
    this.commander = commander;
    this.stopped = stopped;
  }

  void declareIn(Examinations examinations) {
    examinations.test("identification", this::identification);
    examinations.recovery("reset_by_moving", this::reset);
  }

  /** The unit has answered; on the reader's thread. */
  void answered(String question, PtuReply reply) {
    last = reply;
    line.heard().count(question);
  }

  private Finding identification() throws InterruptedException {
    PtuReply reply = want(PtuCommands.VERSION, ANSWER);
    if (reply instanceof Value value) {
      return new Finding(true, "it says it is " + value.text());
    }
    return unanswered(reply, "V", ANSWER);
  }

  private Finding reset() throws InterruptedException {
    if (stopped.getAsBoolean()) {
      return new Finding(
          false, "it moves the head, which is stopped for an emergency; have it released first");
    }
    String someone = commander.get();
    if (someone != null) {
      return new Finding(
          false, "it moves the head, which " + someone + " commands; have its lease closed first");
    }
    PtuReply reply = want(PtuCommands.RESET, RESET);
    return reply instanceof PtuReply.Done
        ? new Finding(true, "the head was turned to its ends and points to 0, 0 now")
        : unanswered(reply, "R", RESET);
  }

  /** Has it asked, and waits for the answer; null when none came. */
  private @Nullable PtuReply want(String question, Duration patience) throws InterruptedException {
    if (!line.isOpen()) {
      return null;
    }
    long before = line.heard().sofar(question);
    protocol.want(question);
    return line.heard().await(question, before, patience) ? last : null;
  }

  private Finding unanswered(@Nullable PtuReply reply, String question, Duration patience) {
    if (!line.isOpen()) {
      return line.link();
    }
    return new Finding(
        false,
        reply instanceof Refused refused
            ? "it refuses " + question + ": " + refused.message()
            : "it has not answered " + question + " within " + LatestReading.seconds(patience));
  }
}

package org.dfra.drivers.gps.m12;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.drivers.gps.m12.M12Heard.Sort;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.module.Precondition;

/**
 * What can be examined and mended on the receiver:
 *
 * <ul>
 *   <li>test {@code link}: the link is open
 *   <li>test {@code identification}: the receiver answers {@code @@Cj} within 3 s
 *   <li>test {@code positions}: position frames come at the set rate
 *   <li>test {@code antenna}: what the last position frame says of the antenna
 *   <li>recovery {@code reopen_link}: the link is closed and opened again, and the receiver speaks
 *   <li>recovery {@code reinitialise}: the receiver is set to its defaults ({@code @@Cf}) and told
 *       anew what to send
 * </ul>
 */
final class M12Examination {

  /** Source: Motorola Oncore M12+ user's guide, technical characteristics. */
  static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("temperature of the receiver", -40, 85, "°C"),
          new Precondition("relative humidity, not condensing", 0, 95, "%"),
          new Precondition("altitude", -1000, 18_000, "m"),
          new Precondition("speed", 0, 515, "m/s"),
          new Precondition("satellites in view of the antenna", 4, 12, ""));

  private static final Duration ANSWER = Duration.ofSeconds(3);
  private static final Duration REOPENING = Duration.ofSeconds(10);

  private final LinkKeeper keeper;
  private final M12Dialogue dialogue;
  private final M12Heard heard;
  private final M12Rate rate;
  private final Supplier<Optional<ReceiverStatus>> status;
  private final Supplier<Optional<ReceiverIdentification>> receiver;

  M12Examination(
      LinkKeeper keeper,
      M12Dialogue dialogue,
      M12Heard heard,
      M12Rate rate,
      Supplier<Optional<ReceiverStatus>> status,
      Supplier<Optional<ReceiverIdentification>> receiver) {
    this.keeper = keeper;
    this.dialogue = dialogue;
    this.heard = heard;
    this.rate = rate;
    this.status = status;
    this.receiver = receiver;
  }

  void declareIn(Examinations examinations) {
    examinations.test("link", this::link);
    examinations.test("identification", this::identification);
    examinations.test("positions", this::positions);
    examinations.test("antenna", this::antenna);
    examinations.recovery("reopen_link", this::reopenLink);
    examinations.recovery("reinitialise", this::reinitialise);
  }

  private Finding link() {
    return keeper.isOpen()
        ? new Finding(true, "the link is open")
        : new Finding(false, "the link is not open: " + keeper.trouble());
  }

  private Finding identification() throws InterruptedException {
    Finding link = link();
    if (!link.passed()) {
      return link;
    }
    long before = heard.sofar(Sort.IDENTIFICATION);
    dialogue.send(M12Commands.identification());
    return heard.await(Sort.IDENTIFICATION, before, ANSWER)
        ? new Finding(
            true, "it says it is " + receiver.get().map(r -> r.model()).orElse("a receiver"))
        : new Finding(false, "it has not answered @@Cj within " + seconds(ANSWER));
  }

  private Finding positions() throws InterruptedException {
    Finding link = link();
    return link.passed() ? solution("the receiver sends position frames") : link;
  }

  private Finding solution(String good) throws InterruptedException {
    Duration patience = rate.longestAge();
    return heard.await(Sort.SOLUTION, heard.sofar(Sort.SOLUTION), patience)
        ? new Finding(true, good)
        : new Finding(false, "no position frame has come within " + seconds(patience));
  }

  private Finding antenna() {
    Optional<ReceiverStatus> last = status.get();
    if (last.isEmpty()) {
      return new Finding(
          false, "no @@Ha has come, and only it tells of the antenna; eight channels have none");
    }
    return switch (last.get().antenna()) {
      case OK -> new Finding(true, "the antenna is connected and draws the right current");
      case OVER_CURRENT ->
          new Finding(false, "the antenna draws too much current: look for a short circuit");
      case UNDER_CURRENT ->
          new Finding(
              false, "the antenna draws too little current: it is not connected, or passive");
      case NO_VOLTAGE -> new Finding(false, "the receiver has no voltage to give its antenna");
    };
  }

  private Finding reopenLink() throws InterruptedException {
    long before = heard.sofar(Sort.OPENING);
    keeper.reopen();
    return heard.await(Sort.OPENING, before, REOPENING)
        ? solution("the link was closed and opened again, and the receiver speaks")
        : new Finding(
            false,
            "the link could not be opened again within "
                + seconds(REOPENING)
                + ": "
                + keeper.trouble());
  }

  private Finding reinitialise() throws InterruptedException {
    Finding link = link();
    if (!link.passed()) {
      return link;
    }
    long before = heard.sofar(Sort.DEFAULTS);
    dialogue.send(M12Commands.defaults());
    if (!heard.await(Sort.DEFAULTS, before, ANSWER)) {
      return new Finding(false, "it has not answered @@Cf within " + seconds(ANSWER));
    }
    return solution("the receiver was set to its defaults and told anew what to send, and sends");
  }

  private static String seconds(Duration duration) {
    return duration.toSeconds() + " s";
  }
}

package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuGeometryQuery.PtuGeometry;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the reader, which is the test's thread, says while another thread's write is held up. */
@Timeout(60)
class PtuProtocolTest {

  private static final List<String> ANSWERS =
      List.of("185.1428", "185.1428", "-3090", "3090", "-907", "604", "31", "2902", "31", "2902");

  private final StepTicker ticker = new StepTicker(false);
  private final List<String> sent = new CopyOnWriteArrayList<>();
  private final List<String> answered = new CopyOnWriteArrayList<>();
  private final CountDownLatch writing = new CountDownLatch(1);
  private final CountDownLatch release = new CountDownLatch(1);
  private final SerialLink link = new ScriptedLink("tcp://unit:4001");
  private final PtuProtocol protocol = new PtuProtocol(new Unit(), ticker, () -> 1, this::send);

  private boolean send(byte[] bytes) {
    String words = new String(bytes, StandardCharsets.US_ASCII);
    sent.add(words);
    if (words.startsWith("PS")) {
      writing.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
    return true;
  }

  @AfterEach
  void release() {
    release.countDown();
  }

  @Test
  void setsTheUnitUpAfterAWriteThatWasHeldUp() throws Exception {
    protocol.opened(link);
    CompletableFuture<Boolean> heldUp = holdUpAWrite();
    pass(300);
    pass(300);
    assertThat(sent).containsExactly("PS9 ");
    letGo(heldUp);
    pass(300);
    assertThat(sent).containsExactly("PS9 ", "ED ", "FT ", "I ");
    bePolling();
  }

  @Test
  void doesNotWaitForTheEndOfAResetThatCouldNotBeSentAndSaysSo() throws Exception {
    protocol.opened(link);
    pass(300);
    bePolling();
    CompletableFuture<Boolean> heldUp = holdUpAWrite();
    protocol.request("R");
    pass(10);
    assertThat(answered).hasSize(1);
    assertThat(answered.get(0)).startsWith("R refused: the line is held up");
    assertThat(protocol.livenessTimeout()).isEqualTo(Duration.ofSeconds(3));
    letGo(heldUp);
    say("*");
    pass(10);
    assertThat(sent).as("the head is not moved late").doesNotContain("R ");
    protocol.request("R");
    pass(10);
    assertThat(sent).endsWith("R ");
    assertThat(protocol.livenessTimeout()).isEqualTo(Duration.ofSeconds(60));
  }

  @Test
  void asksAWantedQuestionAfterAWriteThatWasHeldUp() throws Exception {
    protocol.opened(link);
    pass(300);
    bePolling();
    CompletableFuture<Boolean> heldUp = holdUpAWrite();
    protocol.request("V");
    pass(10);
    assertThat(sent).doesNotContain("V ");
    letGo(heldUp);
    pass(10);
    assertThat(sent).endsWith("V ");
    say("*"); // to what was held up
    say("* v2.14.0");
    assertThat(answered).containsExactly("V v2.14.0");
    pass(10);
    assertThat(sent.stream().filter("V "::equals)).as("once").hasSize(1);
  }

  private CompletableFuture<Boolean> holdUpAWrite() throws InterruptedException {
    CompletableFuture<Boolean> heldUp =
        CompletableFuture.supplyAsync(
            () -> protocol.send(List.of("PS9")), task -> new Thread(task).start());
    assertThat(writing.await(20, TimeUnit.SECONDS)).isTrue();
    return heldUp;
  }

  private void letGo(CompletableFuture<Boolean> heldUp) throws Exception {
    release.countDown();
    assertThat(heldUp.get(20, TimeUnit.SECONDS)).isTrue();
  }

  /** From where the unit is being set up. */
  private void bePolling() {
    say("*");
    say("*");
    say("*");
    for (String answer : ANSWERS) {
      pass(1);
      say("* " + answer);
    }
    pass(1);
    assertThat(sent).endsWith("PP ");
    say("* 0");
    say("* 0");
  }

  private void pass(int millis) {
    ticker.step(Duration.ofMillis(millis));
    protocol.periodic(link);
  }

  private void say(String reply) {
    byte[] bytes = (reply + "\r\n").getBytes(StandardCharsets.US_ASCII);
    protocol.parser().feed(bytes, 0, bytes.length);
  }

  private final class Unit implements PtuProtocol.Listener {

    @Override
    public void geometryReceived(PtuGeometry geometry) {}

    @Override
    public void positionReceived(int pan, int tilt) {}

    @Override
    public void limitHit(PtuAxis axis) {}

    @Override
    public void resetting() {}

    @Override
    public void refused(String command, String reason) {}

    @Override
    public void answered(String question, PtuReply reply) {
      String text =
          reply instanceof Value value
              ? value.text()
              : reply instanceof Refused refused ? "refused: " + refused.message() : "done";
      answered.add(question + " " + text);
    }

    @Override
    public void inconsistentReply(String how) {}

    @Override
    public void lost(String reason) {}

    @Override
    public void alive() {}
  }
}

package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;

import java.time.Duration;
import java.util.Map;
import java.util.Random;
import org.dfra.drivers.fixture.Frames;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;

/** What the driver does when its receiver falls silent, loses its satellites, or says nonsense. */
class M12PlusLinkTest extends ScriptedM12 {

  @Test
  void refusesAPositionThatIsTooOldEvenBeforeTheReaderNotices() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    ticker.step(Duration.ofSeconds(5)); // three periods and 2 s
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    ticker.step(Duration.ofNanos(1));
    assertThatThrownBy(gps::fix).isInstanceOf(NotReadyException.class);
  }

  @Test
  void theLinkOfASilentReceiverIsOpenedAgain() {
    ScriptedLink second = new ScriptedLink(URL);
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    links.add(second);
    ticker.step(Duration.ofSeconds(5).plusNanos(1));
    awaitReadiness(Readiness.INITIALIZING);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::fix,
                    "atrv1/gps_front is INITIALIZING: " + URL + ": no position frame for 5 s"));
    assertThat(link.isOpen()).isFalse();
    ticker.awaitWaiting();
    ticker.step(Duration.ofMillis(500));
    await().until(() -> second.written().size() == ORDERS); // it is configured again
    second.say(FIX);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void silenceIsMeasuredInPeriodsOfTheSetRate() {
    ScriptedLink slow = new ScriptedLink(URL);
    links.clear();
    links.add(slow);
    try (M12PlusImpl driver = driver(Map.of("link", URL, "period", "10"))) {
      assertThat(driver.updateRate()).isEqualTo(0.1);
      driver.start();
      slow.say(FIX);
      await().until(() -> driver.readiness() == Readiness.READY);
      assertThat(slow.written()).contains(M12Commands.positionOf12Channels(10));
      ticker.step(Duration.ofSeconds(32));
      assertThat(driver.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      ticker.step(Duration.ofNanos(1));
      await().until(() -> driver.readiness() == Readiness.INITIALIZING);
    }
  }

  @Test
  void aReceiverWithoutSatellitesKeepsItsLinkButNotItsReadiness() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    for (int second = 0; second < 5; second++) {
      ticker.step(Duration.ofSeconds(1));
      link.say(NO_FIX);
      int frames = second + 2;
      await().until(() -> gps.counts().frames() == frames);
      assertThat(gps.readiness()).isEqualTo(Readiness.READY);
    }
    await().until(() -> gps.fix().mode() == GpsFix.Mode.NONE);
    assertThat(gps.location().position().latitude()).isEqualTo(52.91); // still fresh enough
    ticker.step(Duration.ofNanos(1));
    awaitReadiness(Readiness.INITIALIZING);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::location,
                    "atrv1/gps_front is INITIALIZING: the receiver has no position, it is"
                        + " acquiring satellites, 0 of 0 tracked"));
    assertThat(link.isOpen()).isTrue();
    assertThat(links.tries()).isEqualTo(1);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void anUnpluggedReceiverIsOpenedAgainWhenItIsBack() {
    ScriptedLink second = new ScriptedLink(URL);
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    link.unplug();
    awaitReadiness(Readiness.INITIALIZING);
    for (int tries = 2; tries < 7; tries++) {
      int expected = tries;
      ticker.awaitWaiting();
      ticker.step(Duration.ofSeconds(8)); // the longest wait
      await().until(() -> links.tries() >= expected);
    }
    links.add(second);
    ticker.awaitWaiting();
    ticker.step(Duration.ofSeconds(8));
    second.say(FIX);
    awaitReadiness(Readiness.READY);
    assertThat(warnings())
        .containsExactly(
            URL + ": the device is lost; trying again until it answers",
            URL + ": refused; trying again until it answers");
  }

  @Test
  void countsMalformedFramesAndReportsTheFirst() {
    byte[] impossible = Frames.with(FIX, 15, 200 * 3_600_000, 4);
    gps.start();
    link.say(impossible);
    link.say(impossible);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    await().untilAsserted(() -> assertThat(gps.counts()).isEqualTo(new StreamCounts(3, 0, 2)));
    assertThat(warnings())
        .singleElement()
        .asString()
        .startsWith("malformed @@Ha: latitude (mas) 720000000 is outside");
  }

  @Test
  void aStormOfGarbageCostsNothingButItsBytes() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    gps.start();
    long garbage = 0;
    for (int i = 0; i < 200; i++) {
      byte[] storm = new byte[1 + random.nextInt(4000)];
      random.nextBytes(storm);
      garbage += storm.length;
      link.say(storm);
    }
    link.say(FIX);
    link.say(FIX); // a false head in the last of the garbage may hold back the first
    link.say(FIX);
    await("-Ddfra.seed=" + seed).until(() -> gps.readiness() == Readiness.READY);
    long dropped = garbage;
    await("-Ddfra.seed=" + seed).until(() -> gps.counts().droppedBytes() == dropped);
  }

  @Test
  void garbageIsNoSignOfLife() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    for (int second = 0; second < 6; second++) {
      link.say(new byte[500]);
      ticker.step(Duration.ofSeconds(1));
    }
    awaitReadiness(Readiness.INITIALIZING);
    assertThat(link.isOpen()).isFalse();
  }

  @Test
  void endsCompletelyAndAtOnceInEveryState() {
    gps.start();
    gps.close();
    gps.close();
    gps.start();
    assertThat(gps.readiness()).isEqualTo(Readiness.STOPPED);
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().equals("gps_front reader"));
  }
}

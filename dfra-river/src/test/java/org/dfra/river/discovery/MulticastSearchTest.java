package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.DiscoveryProtocolVersion;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import net.jini.config.ConfigurationException;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.constraint.BasicMethodConstraints.MethodDesc;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A search that is given announcements, and asks servers of the test. No datagram is sent. */
@Timeout(60)
class MulticastSearchTest {

  private static final String GROUP = "field";
  private static final FakeRegistrar HONEST = new FakeRegistrar(7, GROUP);
  private static final long PATIENCE_SECONDS = 20;

  private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
  private final List<AutoCloseable> ending = new ArrayList<>();
  private final AtomicBoolean isOutOfThreads = new AtomicBoolean();
  private volatile LocatedRegistrar last; // that was found
  private MulticastSearch search;

  private final class Recording implements MulticastSearch.Listener {
    @Override
    public void found(LocatedRegistrar registrar) {
      last = registrar;
      events.add("found " + registrar.getServiceID());
    }

    @Override
    public void lost(LocatedRegistrar registrar) {
      events.add("lost " + registrar.getServiceID());
    }
  }

  @BeforeEach
  void begin() throws Exception {
    NetworkInterface[] none = {};
    DiscoveryThreads threads = DiscoveryThreads.begin();
    ThreadFactory usual = threads.probes().getThreadFactory();
    threads
        .probes()
        .setThreadFactory(
            task -> {
              if (isOutOfThreads.compareAndSet(true, false)) {
                throw new OutOfMemoryError("unable to create native thread");
              }
              return usual.newThread(task);
            });
    search =
        MulticastSearch.start(
            new String[] {GROUP},
            MulticastSettings.of(
                new SuppliedConfiguration(
                    Map.of(MulticastSettings.COMPONENT + ".multicastInterfaces", () -> none))),
            new Recording(),
            threads);
  }

  @AfterEach
  void end() throws Exception {
    search.close();
    for (AutoCloseable each : ending) {
      each.close();
    }
  }

  private AnsweringServer serve(AnsweringServer.Answering answering) throws IOException {
    AnsweringServer server = new AnsweringServer(answering);
    ending.add(server);
    return server;
  }

  private AnsweringServer serve(FakeRegistrar registrar) throws IOException {
    byte[] answer = AnsweringServer.answer(registrar, List.of(registrar.getGroups()));
    return serve(out -> out.write(answer));
  }

  private void announce(String host, int port, ServiceID id, String... groups) throws IOException {
    DatagramPacket packet =
        Discovery.getProtocol1()
            .encodeMulticastAnnouncement(
                new MulticastAnnouncement(0, host, port, groups, id),
                512,
                InvocationConstraints.EMPTY)
            .next()[0];
    packet.setAddress(InetAddress.getLoopbackAddress());
    search.received(packet);
  }

  private void announce(AnsweringServer server, ServiceID id, String... groups) throws IOException {
    announce(server.host(), server.port(), id, groups);
  }

  private String event() throws InterruptedException {
    return String.valueOf(events.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
  }

  @Test
  void findsWhatIsAnnouncedOnce() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    for (int i = 0; i < 10; i++) {
      announce(server, HONEST.getServiceID(), GROUP);
    }
    assertThat(search.isDiscovered(HONEST.getServiceID())).isTrue();
    assertThat(server.asked()).isEqualTo(1);
    assertThat(events).isEmpty();
  }

  @Test
  void asksNoneOfAnotherGroupAndTakesNoneThatIsNotOfTheGroupItAnnounced() throws Exception {
    AnsweringServer other = serve(new FakeRegistrar(8, "yard"));
    AnsweringServer liar = serve(new FakeRegistrar(9, "yard"));
    AnsweringServer server = serve(HONEST);
    announce(other, new ServiceID(0, 8), "yard");
    announce("localhost", liar.port(), new ServiceID(0, 9), GROUP);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    assertThat(other.asked()).isZero();
    assertThat(search.isDiscovered(new ServiceID(0, 9))).isFalse();
  }

  @Test
  void findsAnHonestOneBesideManyThatStall() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    try {
      AnsweringServer stalling =
          serve(
              out -> {
                try {
                  over.await();
                } catch (InterruptedException e) {
                  throw new IOException(e);
                }
              });
      for (int i = 0; i < 500; i++) {
        announce("localhost", stalling.port(), new ServiceID(1, i), GROUP);
        announce("127.66.0." + i % 250, 1, new ServiceID(2, i), GROUP);
      }
      AnsweringServer server = serve(HONEST);
      long began = System.nanoTime();
      announce(server, HONEST.getServiceID(), GROUP);
      assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
      assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(5));
      assertThat(stalling.asked()).isLessThanOrEqualTo(DiscoveryCandidates.PROBES);
    } finally {
      over.countDown();
    }
  }

  @Test
  void looksAgainForWhatIsDiscarded() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).startsWith("found");
    search.discard(last);
    assertThat(search.isDiscovered(HONEST.getServiceID())).isFalse();
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    assertThat(server.asked()).isEqualTo(2);
  }

  @Test
  void findsTheHonestOneAfterACopyOfItsServiceId() throws Exception {
    FakeRegistrar copy = new FakeRegistrar(7, "yard"); // another proxy of the same service ID
    byte[] answer = AnsweringServer.answer(copy, List.of(GROUP));
    AnsweringServer stranger = serve(out -> out.write(answer));
    AnsweringServer server = serve(HONEST);
    announce(stranger, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    LocatedRegistrar first = last;
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    assertThat(last.hostAndPort()).isEqualTo(server.host() + ":" + server.port());
    assertThat(search.isDiscovered(last)).isTrue();
    search.discard(first);
    assertThat(search.isDiscovered(last)).as("after the stranger's is discarded").isTrue();
  }

  @Test
  void aLookupServiceAtTwoPlacesIsOne() throws Exception {
    AnsweringServer one = serve(HONEST);
    AnsweringServer two = serve(HONEST);
    announce(one, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    announce(two, HONEST.getServiceID(), GROUP);
    AnsweringServer after = serve(new FakeRegistrar(8, GROUP));
    announce("localhost", after.port(), new ServiceID(0, 8), GROUP);
    assertThat(event()).isEqualTo("found " + new ServiceID(0, 8));
    await().atMost(Duration.ofSeconds(PATIENCE_SECONDS)).until(() -> two.asked() == 1);
    search.discard(last);
    assertThat(event()).as("nothing meanwhile").isEqualTo("found " + new ServiceID(0, 8));
  }

  @Test
  void oneAddressTakesAPartOfThePlacesOnly() throws Exception {
    FoundRegistrars found = new FoundRegistrars();
    for (int i = 0; i < FoundRegistrars.PER_ADDRESS; i++) {
      LocatedRegistrar each = new FakeRegistrar(7, "copy " + i).at("127.0.0.66", i);
      assertThat(found.isRoomFor(each)).isTrue();
      assertThat(found.add(each, "127.0.0.66", List.of(), 0).registrar).isSameAs(each);
    }
    assertThat(found.isRoomFor(new FakeRegistrar(7, "one more").at("127.0.0.66", 1))).isFalse();
    assertThat(found.isRoomFor(new FakeRegistrar(7, "copy 0").at("127.0.0.66", 1)))
        .as("it is found already")
        .isTrue();
    assertThat(found.isRoomFor(HONEST.at("127.0.0.1", 1))).isTrue();
    for (int i = found.all().size(); i < FoundRegistrars.MAX_REGISTRARS; i++) {
      LocatedRegistrar each = new FakeRegistrar(7, "more " + i).at("127.0.1." + i, 1);
      assertThat(found.add(each, "127.0.1." + i, List.of(), 0).registrar).isSameAs(each);
    }
    assertThat(found.isRoomFor(HONEST.at("127.0.0.1", 1))).as("the bound in all").isFalse();
  }

  @Test
  void asksAgainWhereNoThreadCouldBeStarted() throws Exception {
    AnsweringServer server = serve(HONEST);
    isOutOfThreads.set(true);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(isOutOfThreads).as("the failure was met").isFalse();
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
  }

  @Test
  void losesWhatIsOfNoWantedGroupAnyMore() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).startsWith("found");
    search.addGroups(new String[] {"yard"});
    search.removeGroups(new String[] {GROUP});
    assertThat(event()).isEqualTo("lost " + HONEST.getServiceID());
    assertThat(search.getGroups()).containsExactly("yard");
    search.setGroups(null);
    assertThat(search.getGroups()).isNull();
    assertThatThrownBy(() -> search.addGroups(new String[] {GROUP}))
        .isInstanceOf(UnsupportedOperationException.class);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
  }

  @Test
  void dropsDatagramsThatAreNoAnnouncements() throws Exception {
    for (byte[] each : List.of(new byte[0], new byte[3], new byte[512], new byte[] {0, 0, 0, 1})) {
      search.received(
          new DatagramPacket(each, each.length, InetAddress.getLoopbackAddress(), 4160));
    }
    announce("a\u001b[2J", 4160, new ServiceID(5, 5), GROUP);
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
  }

  /** A name service may take long to answer, and knows nothing of the interfaces. */
  @Test
  void asksForAnswersAtAnAddressOfTheInterfacesThatItSendsOn() throws Exception {
    NetworkInterface[] loopback = {
      NetworkInterface.getByInetAddress(InetAddress.getLoopbackAddress())
    };
    assertThat(ofVersion2(loopback).host())
        .isEqualTo(InetAddress.getLoopbackAddress().getHostAddress());
    NetworkInterface[] chosen = {null};
    InetAddress host = InetAddress.getByName(ofVersion2(chosen).host());
    assertThat(NetworkInterface.getByInetAddress(host)).as("that has %s", host).isNotNull();
  }

  private static MulticastSettings ofVersion2(NetworkInterface[] interfaces) throws Exception {
    MethodDesc[] methods = {
      new MethodDesc(
          "multicastRequest", new InvocationConstraints(DiscoveryProtocolVersion.TWO, null))
    };
    return MulticastSettings.of(
        new SuppliedConfiguration(
            Map.of(
                MulticastSettings.COMPONENT + ".discoveryConstraints",
                () -> new BasicMethodConstraints(methods),
                MulticastSettings.COMPONENT + ".multicastInterfaces",
                () -> interfaces)));
  }

  @Test
  void refusesConstraintsThatItCannotFulfil() {
    assertThatThrownBy(
            () ->
                MulticastSettings.of(
                    new SuppliedConfiguration(
                        Map.of(
                            MulticastSettings.COMPONENT + ".discoveryConstraints",
                            () ->
                                new BasicMethodConstraints(
                                    new InvocationConstraints(Integrity.YES, null))))))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("cannot fulfil");
  }
}

package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.EncodeIterator;
import com.sun.jini.discovery.MulticastAnnouncement;
import com.sun.jini.discovery.MulticastAnnouncementDecoder;
import com.sun.jini.discovery.MulticastAnnouncementEncoder;
import com.sun.jini.discovery.MulticastRequest;
import com.sun.jini.discovery.MulticastRequestDecoder;
import com.sun.jini.discovery.MulticastRequestEncoder;
import com.sun.jini.discovery.UnicastDiscoveryClient;
import com.sun.jini.discovery.UnicastDiscoveryServer;
import com.sun.jini.discovery.plaintext.Client;
import com.sun.jini.discovery.plaintext.Server;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.app.benchmark.attack.CallBytes;
import org.dfra.app.benchmark.attack.RawCall;
import org.dfra.app.benchmark.attack.RawCall.Status;
import org.dfra.app.benchmark.attack.SourceBoundProxies;
import org.dfra.app.benchmark.attack.TaskProcess;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.module.LogLevel;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * Valid messages, changed at random, are sent to a robot: no thread of it ends, it keeps no memory,
 * and it still does its work.
 *
 * <p>Short: 100 of each kind, and 300 datagrams. {@code dfra.full}: 10 000. {@code dfra.soak}: a
 * million, and after each {@value #PART} of them threads and memory are checked and progress is
 * printed. {@code -Ddfra.seed=n} repeats a run.
 */
@Timeout(value = 12, unit = TimeUnit.HOURS)
class FuzzIT {

  private static final boolean SOAK = Boolean.getBoolean("dfra.soak");
  private static final boolean FULL = SOAK || Boolean.getBoolean("dfra.full");
  private static final int COUNT = SOAK ? 1_000_000 : FULL ? 10_000 : 100;

  /** Datagrams; they are parsed in this process, which costs little. */
  private static final int DATAGRAMS = Math.max(COUNT, 300);

  /** After so many messages threads and memory are checked, and progress is printed. */
  private static final int PART = 50_000;

  /** So many come before memory is measured: classes are loaded, pools filled. */
  private static final int WARM_UP = 100;

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final int PACKET = 512;

  /** Of threads that pools keep for a while. */
  private static final int POOLED = Victim.THREADS;

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  private final long seed = Long.getLong("dfra.seed", new Random().nextLong());
  private final Random random = new Random(seed);
  private final String repeat = "-Ddfra.seed=" + seed;

  @Test
  void aServedModuleSurvivesChangedCalls() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    ByteMutator mutator = new ByteMutator(random, List.of(hosts.robot(), hosts.attacker()));
    RemoteModuleListener listener = delivery -> {};
    Exporter exporter =
        new BasicJeriExporter(
            hosts.attackerSockets().serverEndpoint(), new BasicILFactory(), false, true);
    try (TaskProcess robot = robot(hosts.robot())) {
      RemoteThermometer module = module(robot, hosts);
      List<byte[]> calls = calls((RemoteModuleListener) exporter.export(listener));
      for (byte[] call : calls) {
        assertThat(send(module, call)).as("an unchanged call").isNotEqualTo(Status.ABORTED);
      }
      sendChanged(WARM_UP, module, calls, mutator);
      Victim victim = Victim.of(robot.pid());
      Progress progress = new Progress("calls", victim, robot);
      for (int done = 0; done < COUNT; progress.reached(done)) {
        int part = Math.min(PART, COUNT - done);
        sendChanged(part, module, calls, mutator);
        done += part;
      }
      assertThat(module.readiness().serves()).as(repeat).isTrue();
      assertThat(module.celsius()).as(repeat).isBetween(-273.15, 1000.0);
      assertNoThreadDied(robot);
    } finally {
      exporter.unexport(true);
    }
  }

  @Test
  void aClientSurvivesChangedAnswersOfDiscovery() throws Exception {
    ByteMutator mutator = new ByteMutator(random, List.of(EmbeddedReggie.HOST));
    try (TaskProcess robot = robot(EmbeddedReggie.HOST);
        AnswerFuzzer fuzzer = new AnswerFuzzer(EmbeddedReggie.HOST, REGGIE.port(), mutator)) {
      robot.write("discover " + fuzzer.locator());
      long patience = PATIENCE.toSeconds() + Math.min(PART, COUNT) / 10;
      fuzzer.awaitAnswers(WARM_UP, patience);
      Victim victim = Victim.of(robot.pid());
      Progress progress = new Progress("answers of discovery", victim, robot);
      for (int done = 0; done < COUNT - PART; progress.reached(done)) {
        done += PART;
        fuzzer.awaitAnswers(WARM_UP + done, patience);
      }
      fuzzer.awaitAnswers(WARM_UP + COUNT, patience);
      System.out.println("connections of discovery that broke: " + fuzzer.broken());
      fuzzer.beHonest();
      robot.write("stop");
      ServiceID honest = REGGIE.registrar().getServiceID();
      assertThat(robot.awaitLine("found", PATIENCE)).as(repeat).isEqualTo("found " + honest);
      progress.reached(COUNT);
    }
  }

  /** What messages of a kind may cost a robot, and how many were sent. */
  private final class Progress {

    private final String what;
    private final Victim victim;
    private final TaskProcess robot;
    private final long began = System.nanoTime();

    Progress(String what, Victim victim, TaskProcess robot) {
      this.what = what;
      this.victim = victim;
      this.robot = robot;
    }

    /** Asserts, after so many messages, that they cost no memory and ended no thread. */
    void reached(int count) {
      victim.assertRecovers(POOLED, Victim.HEAP);
      assertNoThreadDied(robot);
      print(what, count, began);
    }
  }

  private void print(String what, int count, long began) {
    double seconds = (System.nanoTime() - began) / 1e9;
    System.out.printf(
        Locale.ROOT,
        "%d of %d changed %s in %.0f s, %.0f/s; %s%n",
        count,
        COUNT,
        what,
        seconds,
        count / seconds,
        repeat);
  }

  /**
   * In this process: the threads that read datagrams catch every exception, but no error. So an
   * error would end them.
   */
  @Test
  void parsersOfDatagramsThrowNothingButExceptions() throws IOException {
    ByteMutator mutator = new ByteMutator(random, List.of(EmbeddedReggie.HOST));
    List<Discovery> protocols = List.of(Discovery.getProtocol1(), plaintext());
    List<byte[]> datagrams = new ArrayList<>();
    for (Discovery protocol : protocols) {
      datagrams.add(first(protocol.encodeMulticastRequest(request(), PACKET, none())));
      datagrams.add(first(protocol.encodeMulticastAnnouncement(announcement(), PACKET, none())));
      assertThat(parses(datagrams.get(datagrams.size() - 2))).as("an unchanged request").isTrue();
      assertThat(parses(datagrams.get(datagrams.size() - 1))).as("an announcement").isTrue();
    }
    int refused = 0;
    long began = System.nanoTime();
    long heap = heapBytes();
    for (int i = 0; i < DATAGRAMS; i++) {
      byte[] changed = mutator.mutate(datagrams.get(random.nextInt(datagrams.size())));
      try {
        refused += parses(changed) ? 0 : 1;
      } catch (Error e) {
        throw new AssertionError("datagram " + i + ", " + repeat, e);
      }
      if ((i + 1) % PART == 0) {
        print("datagrams", i + 1, began);
      }
    }
    assertThat(heapBytes() - heap).as("bytes that are kept; %s", repeat).isLessThan(Victim.HEAP);
    assertThat(refused).as("datagrams refused; %s", repeat).isBetween(1, DATAGRAMS - 1);
  }

  /** Of objects of this process that are in use. */
  private static long heapBytes() {
    MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
    memory.gc();
    return memory.getHeapMemoryUsage().getUsed();
  }

  private TaskProcess robot(String host) throws IOException, InterruptedException {
    TaskProcess robot = TaskProcess.start(FuzzedRobot.class, host, file().toString());
    try {
      String unused = robot.awaitLine("serves", PATIENCE);
      return robot;
    } catch (IOException e) {
      robot.close();
      throw e;
    }
  }

  private Path file() {
    return folder.resolve("module.ser");
  }

  private RemoteThermometer module(TaskProcess robot, AttackHosts hosts) throws Exception {
    try (ObjectInputStream in = new ObjectInputStream(Files.newInputStream(file()))) {
      return SourceBoundProxies.of((RemoteThermometer) in.readObject(), hosts.attackerSockets());
    } catch (IOException e) {
      throw new IOException("the module of process " + robot.pid() + " cannot be read", e);
    }
  }

  private static List<byte[]> calls(RemoteModuleListener listener) throws Exception {
    Class<?> type = RemoteThermometer.class;
    Class<Duration> duration = Duration.class;
    return List.of(
        CallBytes.of(type.getMethod("celsius")),
        CallBytes.of(type.getMethod("readiness")),
        CallBytes.of(type.getMethod("history")),
        CallBytes.of(type.getMethod("parameters")),
        CallBytes.of(type.getMethod("awaitReadiness", duration), Duration.ofMillis(1)),
        CallBytes.of(type.getMethod("acquireLease", duration), Duration.ofMillis(100)),
        CallBytes.of(type.getMethod("setLogLevel", LogLevel.class), LogLevel.INFO),
        CallBytes.of(type.getMethod("setParameter", String.class, String.class), "celsius", "21"),
        CallBytes.of(
            type.getMethod("subscribe", ModuleListener.class, DeliveryPolicy.class),
            listener,
            DeliveryPolicy.keepLast(10)));
  }

  private void sendChanged(
      int count, RemoteThermometer module, List<byte[]> calls, ByteMutator mutator)
      throws Exception {
    for (int i = 0; i < count; i++) {
      byte[] changed = mutator.mutate(calls.get(random.nextInt(calls.size())));
      assertThat(send(module, changed)).as("call %d, %s", i, repeat).isNotEqualTo(Status.SILENT);
    }
  }

  /** The server may refuse a request before it has all of it. */
  private static Status send(RemoteThermometer module, byte[] bytes) throws Exception {
    try (RawCall call = RawCall.to(module)) {
      try {
        return call.send(bytes).finish(PATIENCE).status();
      } catch (IOException e) {
        return Status.ABORTED;
      }
    }
  }

  private void assertNoThreadDied(TaskProcess robot) {
    assertThat(robot.isAlive()).as("the robot's process; %s", repeat).isTrue();
    assertThat(robot.lines())
        .as("threads that ended; %s; %s", repeat, robot.log())
        .noneMatch(line -> line.startsWith(FuzzedRobot.DIED));
  }

  private static InvocationConstraints none() {
    return InvocationConstraints.EMPTY;
  }

  private static MulticastRequest request() {
    return new MulticastRequest(
        EmbeddedReggie.HOST, 4711, new String[] {"fuzz"}, new ServiceID[] {new ServiceID(1, 2)});
  }

  private static MulticastAnnouncement announcement() {
    return new MulticastAnnouncement(
        1, EmbeddedReggie.HOST, 4711, new String[] {"fuzz"}, new ServiceID(1, 2));
  }

  private static byte[] first(EncodeIterator packets) throws IOException {
    DatagramPacket packet = packets.next()[0];
    byte[] bytes = new byte[packet.getLength()];
    System.arraycopy(packet.getData(), packet.getOffset(), bytes, 0, bytes.length);
    return bytes;
  }

  /** Protocol 2 without the formats that need keys. */
  private static Discovery plaintext() {
    Client client = new Client();
    Server server = new Server();
    return Discovery.getProtocol2(
        new MulticastRequestEncoder[] {client},
        new MulticastRequestDecoder[] {server},
        new MulticastAnnouncementEncoder[] {server},
        new MulticastAnnouncementDecoder[] {client},
        new UnicastDiscoveryClient[] {client},
        new UnicastDiscoveryServer[] {server});
  }

  /** Whether any of the four parsers takes it. */
  private static boolean parses(byte[] bytes) throws IOException {
    boolean taken = false;
    for (Discovery protocol : List.of(Discovery.getProtocol1(), plaintext())) {
      taken |= isRequest(protocol, bytes);
      taken |= isAnnouncement(protocol, bytes);
    }
    return taken;
  }

  private static boolean isRequest(Discovery protocol, byte[] bytes) throws IOException {
    try {
      return protocol.decodeMulticastRequest(packet(bytes), none(), null).getGroups() != null;
    } catch (IOException | RuntimeException e) { // refused: the listener's thread catches both
      return false;
    }
  }

  private static boolean isAnnouncement(Discovery protocol, byte[] bytes) throws IOException {
    try {
      return protocol.decodeMulticastAnnouncement(packet(bytes), none()).getGroups() != null;
    } catch (IOException | RuntimeException e) { // refused: the listener's thread catches both
      return false;
    }
  }

  /** As it is received: in a buffer for the longest. */
  private static DatagramPacket packet(byte[] bytes) throws IOException {
    byte[] buffer = new byte[Math.max(PACKET, bytes.length)];
    System.arraycopy(bytes, 0, buffer, 0, bytes.length);
    return new DatagramPacket(
        buffer, 0, bytes.length, InetAddress.getByName(EmbeddedReggie.HOST), 4711);
  }
}

package org.dfra.attack.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.sun.jini.discovery.Discovery;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.UncheckedIOException;
import java.lang.Thread.UncaughtExceptionHandler;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.lookup.entry.Name;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.host.FreePorts;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.discovery.DatagramSearch;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.testing.EmbeddedReggie;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * Valid messages, changed at random, are sent to a module, a registrar, phoenix and clients: no
 * thread of them ends, they keep no memory, and they still do their work.
 *
 * <p>Short: 100 calls, split among the three servers, 100 answers and 300 datagrams. {@code
 * dfra.full}: 10 000 to each server, and of each other kind. {@code dfra.soak}: a million, and
 * after each {@value #PART} of them threads and memory are checked and progress is printed; the
 * figures are appended to {@code benchmarks/fuzz-soak.csv}. {@code -Ddfra.seed=n} repeats a run.
 */
@Timeout(value = 12, unit = TimeUnit.HOURS)
class FuzzIT {

  private static final boolean SOAK = Boolean.getBoolean("dfra.soak");
  private static final boolean FULL = SOAK || Boolean.getBoolean("dfra.full");
  private static final int COUNT = SOAK ? 1_000_000 : FULL ? 10_000 : 100;

  /** So many remote objects are sent changed calls: a module, a registrar, phoenix. */
  private static final int TARGETS = 3;

  /** Calls of each of them. */
  private static final int CALLS = FULL ? COUNT : (COUNT + TARGETS - 1) / TARGETS;

  /** Datagrams; they are parsed in this process, which costs little. */
  private static final int DATAGRAMS = Math.max(COUNT, 300);

  /** After so many messages threads and memory are checked, and progress is printed. */
  private static final int PART = 50_000;

  /** So many come before memory is measured: classes are loaded, pools filled. */
  private static final int WARM_UP = 100;

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /**
   * Makes every collection drop what a process keeps only while memory is free. For each changed
   * class descriptor the JDK keeps an entry of about 200 bytes so (ObjectStreamClass, reflectors);
   * a million calls would seem to cost 12 MB.
   */
  static final String NO_SOFT_REFERENCES = "-XX:SoftRefLRUPolicyMSPerMB=0";

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  private final long seed = Long.getLong("dfra.seed", new Random().nextLong());
  private final Random random = new Random(seed);
  private final String repeat = "-Ddfra.seed=" + seed;

  @Test
  void aModuleSurvivesChangedCalls() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    Exporter exporter = attackersExporter(hosts);
    RemoteModuleListener listener = delivery -> {}; // JERI holds it weakly
    try (TaskProcess robot = robot(hosts.robot())) {
      RemoteThermometer module = module(robot, hosts);
      survives(
          FuzzTarget.module(module, (RemoteModuleListener) exporter.export(listener)),
          hosts,
          robot.pid(),
          () -> assertNoThreadDied(robot));
      assertThat(module.readiness().serves()).as(repeat).isTrue();
      assertThat(module.celsius()).as(repeat).isBetween(-273.15, 1000.0);
    } finally {
      exporter.unexport(true);
    }
  }

  @Test
  void aRegistrarSurvivesChangedCalls() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    Exporter exporter = attackersExporter(hosts);
    RemoteEventListener listener = event -> {}; // JERI holds it weakly
    try (TaskProcess robot = robot(hosts.robot(), FuzzedRobot.WITH_REGISTRAR)) {
      int port = Integer.parseInt(robot.lines().get(0).split(" ")[1]);
      ServiceRegistrar registrar =
          SourceBoundProxies.registrar(hosts.robot(), port, hosts.attackerSockets());
      survives(
          FuzzTarget.registrar(registrar, (RemoteEventListener) exporter.export(listener)),
          hosts,
          robot.pid(),
          () -> assertNoThreadDied(robot));
      assertRegisters(new LookupLocator(hosts.robot(), port).getRegistrar());
    } finally {
      exporter.unexport(true);
    }
  }

  private static Exporter attackersExporter(AttackHosts hosts) {
    return new BasicJeriExporter(
        hosts.attackerSockets().serverEndpoint(), new BasicILFactory(), false, true);
  }

  /** It still does its work, for an honest client. */
  private void assertRegisters(ServiceRegistrar registrar) throws RemoteException {
    ServiceRegistration honest = Fakes.register(registrar, null, "honest", new Name("honest"));
    assertThat(Fakes.proxy(registrar, honest.getServiceID())).as(repeat).contains("honest");
  }

  @Test
  void phoenixSurvivesChangedOrdersToStop() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    PhoenixProcess phoenix =
        new PhoenixProcess(
            EmbeddedReggie.HOST, FreePorts.allocate(), -1, folder.resolve("phoenix"));
    Process process = phoenix.start(PATIENCE);
    Thread lastResort = new Thread(process::destroyForcibly, "ends phoenix " + process.pid());
    Runtime.getRuntime().addShutdownHook(lastResort);
    try {
      survives(
          FuzzTarget.stopService(phoenix),
          hosts,
          phoenix.pid().orElseThrow(),
          () -> assertNoThreadDied(phoenix));
      assertThat(phoenix.admin().groupStatus()).as(repeat).isEmpty();
      phoenix.shutdown(PATIENCE);
    } finally {
      process.destroyForcibly();
      Runtime.getRuntime().removeShutdownHook(lastResort);
    }
  }

  /** Virtual machines report the end of a thread so, and phoenix sets no handler of its own. */
  private void assertNoThreadDied(PhoenixProcess phoenix) {
    assertThat(phoenix.pid()).as("phoenix; %s", repeat).isPresent();
    try (Stream<String> log = Files.lines(phoenix.log())) {
      assertThat(log).as(repeat).noneMatch(line -> line.contains("Exception in thread"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void survives(FuzzTarget target, AttackHosts hosts, long pid, Runnable alive)
      throws Exception {
    ByteMutator mutator =
        new ByteMutator(random, List.of(hosts.robot(), hosts.attacker(), EmbeddedReggie.HOST));
    for (byte[] call : target.calls()) {
      assertThat(target.send(call, PATIENCE))
          .as("an unchanged call of %s", target.name())
          .isIn(Status.RETURNED, Status.THREW);
    }
    var unused = sendChanged(WARM_UP / TARGETS, target, mutator);
    try (FuzzProgress progress =
        new FuzzProgress(seed, "calls to " + target.name(), CALLS, pid, alive)) {
      for (int done = 0; done < CALLS; progress.reached(done)) {
        int part = Math.min(PART, CALLS - done);
        Map<Status, Integer> outcomes = sendChanged(part, target, mutator);
        System.out.println("calls to " + target.name() + ": " + outcomes);
        assertThat(outcomes).as(repeat).containsKeys(Status.RETURNED, Status.THREW);
        done += part;
      }
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
      try (FuzzProgress progress =
          new FuzzProgress(
              seed, "answers of discovery", COUNT, robot.pid(), () -> assertNoThreadDied(robot))) {
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
  }

  /**
   * In this process: the threads that read datagrams catch every exception, but no error. So an
   * error would end them. Each datagram is parsed as reggie and clients parse it, and then received
   * by a search, which asks what it announces.
   */
  @Test
  void parsersAndASearchSurviveChangedDatagrams() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    String host = hosts.robot(); // nothing listens there
    ByteMutator mutator = new ByteMutator(random, List.of(host));
    List<byte[]> datagrams = new ArrayList<>();
    for (Discovery protocol : DiscoveryDatagrams.protocols()) {
      datagrams.add(DiscoveryDatagrams.request(protocol, host));
      datagrams.add(DiscoveryDatagrams.announcement(protocol, host, 4711, new ServiceID(1, 2)));
      assertThat(DiscoveryDatagrams.parses(datagrams.get(datagrams.size() - 2)))
          .as("an unchanged request")
          .isTrue();
      assertThat(DiscoveryDatagrams.parses(datagrams.get(datagrams.size() - 1)))
          .as("an announcement")
          .isTrue();
    }
    List<String> died = new CopyOnWriteArrayList<>();
    @Nullable UncaughtExceptionHandler usual = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler((thread, e) -> died.add(thread.getName() + ": " + e));
    int refused = 0;
    try (DatagramSearch search = new DatagramSearch(Set.of(host, EmbeddedReggie.HOST));
        FuzzProgress progress =
            new FuzzProgress(
                seed,
                "datagrams of discovery",
                DATAGRAMS,
                ProcessHandle.current().pid(),
                () -> assertThat(died).as("threads that ended; %s", repeat).isEmpty())) {
      for (int i = 0; i < DATAGRAMS; i++) {
        byte[] changed = mutator.mutate(datagrams.get(random.nextInt(datagrams.size())));
        try {
          refused += DiscoveryDatagrams.parses(changed) ? 0 : 1;
          search.receive(DiscoveryDatagrams.packet(changed));
        } catch (RuntimeException | Error e) {
          throw new AssertionError("datagram " + i + ", " + repeat, e);
        }
        if ((i + 1) % PART == 0) {
          progress.reached(i + 1);
        }
      }
      progress.reached(DATAGRAMS);
      System.out.println("datagrams that named other hosts: " + search.withheld());
      assertThat(search.withheld()).as(repeat).isLessThan(DATAGRAMS / 2);
      assertFinds(search);
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(usual);
    }
    assertThat(refused).as("datagrams refused; %s", repeat).isBetween(1, DATAGRAMS - 1);
  }

  /** It still finds an honest lookup service by its announcement. */
  private void assertFinds(DatagramSearch search) throws IOException {
    ServiceID honest = REGGIE.registrar().getServiceID();
    byte[] announced =
        DiscoveryDatagrams.announcement(
            DiscoveryDatagrams.plaintext(), EmbeddedReggie.HOST, REGGIE.port(), honest);
    assertThat(search.isDiscovered(honest)).as(repeat).isFalse();
    search.receive(DiscoveryDatagrams.packet(announced));
    await(repeat).atMost(PATIENCE).until(() -> search.isDiscovered(honest));
  }

  private TaskProcess robot(String host, String... options)
      throws IOException, InterruptedException {
    List<String> arguments = new ArrayList<>(List.of(host, file().toString()));
    arguments.addAll(List.of(options));
    TaskProcess robot =
        TaskProcess.start(
            List.of(),
            List.of(NO_SOFT_REFERENCES),
            FuzzedRobot.class,
            arguments.toArray(String[]::new));
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

  private Map<Status, Integer> sendChanged(int count, FuzzTarget target, ByteMutator mutator)
      throws Exception {
    Map<Status, Integer> outcomes = new EnumMap<>(Status.class);
    for (int i = 0; i < count; i++) {
      byte[] changed = mutator.mutate(target.calls().get(random.nextInt(target.calls().size())));
      Status status = target.send(changed, PATIENCE);
      assertThat(status)
          .as("call %d of %s, %s", i, target.name(), repeat)
          .isNotEqualTo(Status.SILENT);
      outcomes.merge(status, 1, Integer::sum);
    }
    return outcomes;
  }

  private void assertNoThreadDied(TaskProcess robot) {
    assertThat(robot.isAlive()).as("the robot's process; %s", repeat).isTrue();
    assertThat(robot.lines())
        .as("threads that ended; %s; %s", repeat, robot.log())
        .noneMatch(line -> line.startsWith(FuzzedRobot.DIED));
  }
}

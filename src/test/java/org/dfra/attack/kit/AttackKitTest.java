package org.dfra.attack.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Method;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.NoSuchObjectException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import org.dfra.attack.kit.HonestService.Adder;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.task.TaskProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What attacks are made of does what it says, against one honest object. */
@Timeout(120)
class AttackKitTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  /** For what must not happen. */
  private static final Duration BRIEF = Duration.ofMillis(300);

  private final AttackHosts hosts = AttackHosts.assumed();
  private HonestService service;
  private Method add;

  @BeforeEach
  void export() throws Exception {
    service = new HonestService(hosts.robot());
    add = Adder.class.getMethod("add", int.class, int.class);
  }

  @AfterEach
  void end() {
    service.close();
  }

  @Test
  void stockProxiesCallFromTheAttackersAddress() throws Exception {
    assertThat(service.proxy().client()).isNotEqualTo(hosts.attacker());
    Adder attackers = SourceBoundProxies.of(service.proxy(), hosts.attackerSockets());
    assertThat(attackers.client()).isEqualTo(hosts.attacker());
    assertThat(SourceBoundProxies.of(attackers, hosts.operatorSockets()).client())
        .isEqualTo(hosts.operator());
    assertThat(SourceBoundProxies.remote(List.of("smart", attackers), Adder.class).client())
        .isEqualTo(hosts.attacker());
  }

  @Test
  void connectionsOfTheirOwnAreNotShared() {
    assertThat(hosts.attackerSockets()).isEqualTo(hosts.attackerSockets());
    assertThat(hosts.attackerSockets().unshared())
        .isNotEqualTo(hosts.attackerSockets())
        .isNotEqualTo(hosts.attackerSockets().unshared());
  }

  @Test
  void aCallWrittenByHandIsExecuted() throws Exception {
    try (RawCall call = raw()) {
      Answer answer = call.send(CallBytes.of(add, 2, 3)).finish(PATIENCE);
      assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.RETURNED);
      assertThat(answer.stream().readInt()).isEqualTo(5);
    }
    assertThat(service.proxy().additions()).isEqualTo(1);
  }

  @Test
  void anUnfinishedCallIsNeitherExecutedNorAnswered() throws Exception {
    byte[] bytes = CallBytes.of(add, 2, 3);
    try (RawCall call = raw()) {
      call.send(bytes, bytes.length - 1);
      assertThat(service.proxy().additions()).isZero();
    }
    assertThat(service.proxy().additions()).isZero();
  }

  @Test
  void aCallThatWasCutIsRefused() throws Exception {
    byte[] bytes = CallBytes.of(add, 2, 3);
    try (RawCall call = raw()) {
      Answer answer = call.send(bytes, bytes.length - 1).finish(PATIENCE);
      assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.THREW);
      assertThat(answer.object()).isInstanceOf(IOException.class);
    }
    assertThat(service.proxy().additions()).isZero();
  }

  @Test
  void aMethodThatIsNotThereAndAnUnknownVersionAreRefused() throws Exception {
    try (RawCall call = raw()) {
      Answer answer = call.send(CallBytes.with(4711, out -> {})).finish(PATIENCE);
      assertThat(answer.status()).isEqualTo(Status.THREW);
    }
    byte[] bytes = CallBytes.of(add, 2, 3);
    bytes[0] = 9;
    try (RawCall call = raw()) {
      assertThat(call.send(bytes).finish(PATIENCE).status()).isEqualTo(Status.MISMATCH);
    }
  }

  @Test
  void anObjectThatIsNotThereIsReportedAsSuch() throws Exception {
    BasicObjectEndpoint known = (BasicObjectEndpoint) RawCall.endpoint(service.proxy());
    ObjectEndpoint unknown =
        new BasicObjectEndpoint(known.getEndpoint(), UuidFactory.generate(), false);
    try (RawCall call = RawCall.to(unknown)) {
      Answer answer = call.send(CallBytes.of(add, 2, 3)).finish(PATIENCE);
      assertThat(answer.status()).isEqualTo(Status.NO_SUCH_OBJECT);
      assertThat(answer.failure()).isInstanceOf(NoSuchObjectException.class);
    }
  }

  @Test
  void aCallThatIsNotAnsweredIsSilent() throws Exception {
    try (RawCall call = raw()) {
      call.send(CallBytes.of(Adder.class.getMethod("hang")));
      assertThat(call.finish(BRIEF).status()).isEqualTo(Status.SILENT);
    }
  }

  @Test
  void aTaskRunsInAProcessOfItsOwn() throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getByName(hosts.robot()));
        TaskProcess task =
            TaskProcess.start(
                ShowSource.class,
                hosts.attacker(),
                hosts.robot(),
                Integer.toString(server.getLocalPort()))) {
      server.setSoTimeout(Math.toIntExact(PATIENCE.toMillis()));
      try (Socket client = server.accept()) {
        assertThat(client.getInetAddress().getHostAddress()).isEqualTo(hosts.attacker());
      }
      assertThat(task.awaitLine("connected", PATIENCE))
          .isEqualTo("connected from " + hosts.attacker());
      assertThat(task.awaitEnd(PATIENCE)).isZero();
      assertThat(task.pid()).isNotEqualTo(ProcessHandle.current().pid());
      assertThatThrownBy(() -> task.awaitLine("", BRIEF)).hasMessageContaining("ended");
    }
  }

  @Test
  void aVictimsThreadsAndHeapAreSeen() throws Exception {
    int count = Victim.THREADS + 10;
    try (TaskProcess task = TaskProcess.start(HoldThreads.class, Integer.toString(count))) {
      String unused = task.awaitLine("ready", PATIENCE);
      Victim victim = Victim.of(task.pid());
      victim.assertWithinLimits();
      task.write("");
      String held = task.awaitLine("holds", PATIENCE);
      assertThat(held).isEqualTo("holds " + count);
      assertThat(victim.moreThreads()).isGreaterThanOrEqualTo(count);
      assertThat(victim.moreHeap()).isGreaterThan(count * (1L << 18));
      assertThatThrownBy(victim::assertWithinLimits).isInstanceOf(AssertionError.class);
      assertThat(victim.cpuSince()).isPositive();
    }
  }

  @Test
  void aDaemonThatATaskHasStartedEndsWithIt() throws Exception {
    Process daemon = new ProcessBuilder("sleep", "600").start();
    try {
      try (TaskProcess task = TaskProcess.start(HoldThreads.class, "1")) {
        task.killWithThis(daemon.pid());
        assertThatThrownBy(() -> task.killWithThis(daemon.pid()))
            .isInstanceOf(IllegalStateException.class)
            .hasMessageContaining("process " + daemon.pid());
        assertThat(daemon.isAlive()).isTrue();
      }
      assertThat(daemon.waitFor(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)).isTrue();
    } finally {
      daemon.destroyForcibly();
    }
  }

  private RawCall raw() throws IOException {
    return RawCall.to(SourceBoundProxies.of(service.proxy(), hosts.attackerSockets()));
  }
}

package org.dfra.attack.fuzz;

import static java.io.ObjectStreamConstants.SC_SERIALIZABLE;
import static java.io.ObjectStreamConstants.TC_CLASSDESC;
import static java.io.ObjectStreamConstants.TC_ENDBLOCKDATA;
import static java.io.ObjectStreamConstants.TC_NULL;
import static java.io.ObjectStreamConstants.TC_OBJECT;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.example.thermometer.RemoteThermometer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Calls whose arguments are of classes that nobody has: the names, which the virtual machine would
 * keep for ever, would fill its heap.
 */
@Timeout(180)
class InventedNamesIT {

  private static final int CALLS = 600;

  /**
   * A class and its superclasses. Kept for ever, the names of all calls would occupy half as much
   * again as an attack may.
   */
  private static final int NAMES_OF_A_CALL = 20;

  /** They load the classes that refuse. */
  private static final int WARM_UP = 20;

  private static final int NAME_CHARACTERS = 950; // longer ones are refused without a look

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @TempDir Path folder;

  private final AttackHosts hosts = AttackHosts.assumed();

  @Test
  void namesOfClassesLeaveNothing() throws Exception {
    Path file = folder.resolve("module.ser");
    try (TaskProcess robot =
        TaskProcess.start(
            List.of(),
            List.of(FuzzIT.NO_SOFT_REFERENCES),
            FuzzedRobot.class,
            hosts.robot(),
            "" + file)) {
      String unused = robot.awaitLine("serves", PATIENCE);
      RemoteThermometer module;
      try (ObjectInputStream in = new ObjectInputStream(Files.newInputStream(file))) {
        module =
            SourceBoundProxies.of((RemoteThermometer) in.readObject(), hosts.attackerSockets());
      }
      byte[] call =
          CallBytes.with(
              RemoteThermometer.class.getMethod("awaitReadiness", Duration.class), out -> {});
      for (int i = 0; i < WARM_UP; i++) {
        send(module, call, CALLS + i);
      }
      Victim victim = Victim.of(robot.pid());
      for (int i = 0; i < CALLS; i++) {
        send(module, call, i);
      }
      victim.assertCpuPerCall(CALLS);
      victim.assertRecovers(Victim.THREADS, Victim.HEAP);
      assertThat(module.celsius()).isBetween(-273.15, 1000.0);
    }
  }

  private static void send(RemoteThermometer module, byte[] call, int number) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(call);
    writeObject(number, new DataOutputStream(bytes));
    try (RawCall raw = RawCall.to(module)) {
      Answer answer = raw.send(bytes.toByteArray()).finish(PATIENCE);
      assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.THREW);
      assertThat((Throwable) answer.object()).hasStackTraceContaining("ClassNotFoundException");
    }
  }

  private static void writeObject(int number, DataOutputStream out) throws IOException {
    String end = "x".repeat(NAME_CHARACTERS);
    out.writeByte(TC_OBJECT);
    for (int i = 0; i < NAMES_OF_A_CALL; i++) {
      writeClass("org.dfra.Invented" + number + "x" + i + end, out);
    }
    out.writeByte(TC_NULL); // no more superclasses
  }

  /** A class without fields and without a codebase. */
  private static void writeClass(String name, DataOutputStream out) throws IOException {
    out.writeByte(TC_CLASSDESC);
    out.writeUTF(name);
    out.writeLong(1);
    out.writeByte(SC_SERIALIZABLE);
    out.writeShort(0);
    out.writeByte(TC_NULL);
    out.writeByte(TC_ENDBLOCKDATA);
  }
}

package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationGroup;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The registry by which old Jini programs find phoenix. */
class RegistryIT {

  @TempDir Path temp;
  private PhoenixFixture phoenix;

  @BeforeEach
  void start() throws Exception {
    phoenix = new PhoenixFixture(temp).withRegistry().start();
  }

  @AfterEach
  void end() {
    phoenix.close();
  }

  @Test
  void readOnlyRegistryLeadsToTheSystemAndTakesNothing() throws Exception {
    Registry registry = LocateRegistry.getRegistry("127.0.0.1", phoenix.registryPort);
    String name = "java.rmi.activation.ActivationSystem";
    assertThat(registry.list()).containsExactly(name);
    assertThat(registry.lookup(name)).isEqualTo(phoenix.system());
    // A caller of its own, since a virtual machine looks its system up once.
    Process caller =
        new ProcessBuilder(
                java.util.stream.Stream.of(
                        List.of(org.dfra.river.bootstrap.JvmCommand.java()),
                        org.dfra.river.bootstrap.JvmCommand.options(),
                        List.of(
                            "-Djava.rmi.activation.port=" + phoenix.registryPort,
                            SystemFinder.class.getName()))
                    .flatMap(List::stream)
                    .toList())
            .redirectErrorStream(true)
            .start();
    assertThat(new String(caller.getInputStream().readAllBytes()))
        .contains("found " + phoenix.admin().getActivationGroups().size() + " groups");
    for (Change change :
        List.<Change>of(
            () -> registry.bind("mine", registry),
            () -> registry.rebind(name, registry),
            () -> registry.rebind(name, phoenix.system()),
            () -> registry.unbind(name))) {
      assertThatExceptionOfType(RemoteException.class).isThrownBy(change::run);
    }
    assertThat(registry.list()).as("what is bound after all that").containsExactly(name);
  }

  private interface Change {
    void run() throws Exception;
  }

  /** A program that knows only {@code java.rmi.activation}. */
  static final class SystemFinder {
    private SystemFinder() {}

    /** Prints how many groups the system has. */
    public static void main(String[] args) throws Exception {
      System.out.println(
          "found "
              + ((org.dfra.river.phoenix.PhoenixAdmin) ActivationGroup.getSystem())
                  .getActivationGroups()
                  .size()
              + " groups");
    }
  }
}

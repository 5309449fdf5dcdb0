package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.UnknownGroupException;
import java.util.List;
import net.jini.activation.ActivationGroup;
import org.dfra.river.fixture.ChildJvm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A program that makes itself a group, and is refused. */
@Timeout(120)
class RefusedGroupTest {

  @Test
  void aRefusedGroupLeavesNoJvmAlive() throws Exception {
    assertThat(ChildJvm.run(Refused.class, List.of())).contains("refused: unregistered");
  }

  /** Ends its main with its group refused. */
  static final class Refused {

    private static final int STILL_ALIVE = 3;

    public static void main(String[] args) throws Exception {
      Thread watchdog = new Thread(Refused::haltLate, "watchdog");
      watchdog.setDaemon(true); // so it does not keep the virtual machine alive itself
      watchdog.start();
      ActivationSystem system =
          (ActivationSystem)
              Proxy.newProxyInstance(
                  Refused.class.getClassLoader(),
                  new Class<?>[] {ActivationSystem.class},
                  (proxy, method, arguments) -> {
                    throw new UnknownGroupException("unregistered");
                  });
      ActivationGroupDesc desc =
          new ActivationGroupDesc(ActivationGroupImpl.class.getName(), null, null, null, null);
      try {
        ActivationGroup.createGroup(new ActivationGroupID(system), desc, 1);
      } catch (ActivationException e) {
        System.out.println("refused: " + e.getMessage());
      }
    }

    private static void haltLate() {
      try {
        Thread.sleep(40_000);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      System.out.println("still alive");
      Runtime.getRuntime().halt(STILL_ALIVE);
    }
  }
}

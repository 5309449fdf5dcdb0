package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.time.Duration;
import java.util.List;
import net.jini.core.constraint.RemoteMethodControl;
import org.dfra.river.call.DeadlineContract.Service;
import org.junit.jupiter.api.Test;

class ReceivedDeadlineTest {

  /** Its sender chooses the deadline, but this computer's threads wait. */
  @Test
  void aReceivedDeadlineIsAtMostTenSecondsOrThirtyForAnActivator() throws Exception {
    Method echo = Service.class.getMethod("echo", String.class);
    Method activate = Activator.class.getMethod("activate", ActivationID.class, boolean.class);
    Service hours =
        DeadlineContract.proxy(
            Endpoints.tcpClient("127.0.0.1", 4160), Duration.ofHours(2).toMillis());
    RemoteMethodControl read = (RemoteMethodControl) DeadlineContract.received(hours);
    for (Object each : List.of(read, read.setConstraints(null))) {
      DeadlineInvocationHandler handler =
          (DeadlineInvocationHandler) Proxy.getInvocationHandler(each);
      assertThat(handler.deadlineMillis(echo)).isEqualTo(10_000);
      assertThat(handler.deadlineMillis(activate)).isEqualTo(30_000);
    }
    assertThat(((DeadlineInvocationHandler) Proxy.getInvocationHandler(hours)).deadlineMillis(echo))
        .as("of one that is used where it was made")
        .isEqualTo(Duration.ofHours(2).toMillis());
  }
}

package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.InetAddress;
import java.net.NetworkInterface;
import java.rmi.AccessException;
import java.rmi.RemoteException;
import java.util.List;
import net.jini.export.ServerContext;
import net.jini.io.context.ClientHost;
import org.dfra.river.phoenix.access.LocalCallerGuard;
import org.junit.jupiter.api.Test;

/** Who may register and monitor. */
class LocalCallerGuardTest {

  private final LocalCallerGuard access = new LocalCallerGuard();

  @Test
  void callersOnEveryAddressOfThisMachineAreAccepted() throws Exception {
    List<InetAddress> own =
        NetworkInterface.networkInterfaces().flatMap(NetworkInterface::inetAddresses).toList();
    assertThat(own).isNotEmpty();
    for (InetAddress address : own) {
      assertThatCode(() -> checkFrom(address)).as("%s", address).doesNotThrowAnyException();
    }
    assertThatCode(() -> checkFrom(InetAddress.getByName("127.1.2.3"))).doesNotThrowAnyException();
  }

  @Test
  void callersInThisVirtualMachineAreAccepted() {
    assertThatCode(() -> access.check("registerGroup")).doesNotThrowAnyException();
  }

  @Test
  void callersFromElsewhereAreRefusedByAddress() throws Exception {
    // TEST-NET-3 and the documentation prefix (RFC 5737, RFC 3849): no machine has them.
    for (String elsewhere : List.of("203.0.113.7", "2001:db8:0:0:0:0:0:7")) {
      InetAddress address = InetAddress.getByName(elsewhere);
      assertThatExceptionOfType(AccessException.class)
          .isThrownBy(() -> checkFrom(address))
          .withMessageContaining("registerGroup is refused to " + elsewhere);
    }
  }

  @Test
  void everyMethodOfSystemAndMonitorAsks() throws Exception {
    InetAddress elsewhere = InetAddress.getByName("203.0.113.7");
    for (Object service :
        List.of(
            new SystemService(null, null, null, access),
            new Phoenix.MonitorService(null, null, access))) {
      for (Class<?> type : service.getClass().getInterfaces()) {
        for (var method : type.getMethods()) {
          Object[] arguments =
              java.util.Arrays.stream(method.getParameterTypes())
                  .map(parameter -> parameter == long.class ? 1L : null)
                  .toArray();
          assertThatExceptionOfType(java.lang.reflect.InvocationTargetException.class)
              .as("%s", method)
              .isThrownBy(() -> from(elsewhere, () -> method.invoke(service, arguments)))
              .withCauseInstanceOf(AccessException.class);
        }
      }
    }
  }

  private void checkFrom(InetAddress address) throws Exception {
    from(
        address,
        () -> {
          access.check("registerGroup");
          return null;
        });
  }

  private interface Call {
    Object run() throws ReflectiveOperationException, RemoteException;
  }

  private static void from(InetAddress address, Call call) throws Exception {
    Exception[] thrown = new Exception[1];
    ServerContext.doWithServerContext(
        () -> {
          try {
            call.run();
          } catch (ReflectiveOperationException | RemoteException e) {
            thrown[0] = e;
          }
        },
        List.of((ClientHost) () -> address));
    if (thrown[0] != null) {
      throw thrown[0];
    }
  }
}

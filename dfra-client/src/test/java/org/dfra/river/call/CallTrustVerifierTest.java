package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.List;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.jeri.Endpoint;
import net.jini.jeri.OutboundRequestIterator;
import net.jini.security.Security;
import org.dfra.river.call.DeadlineContract.Service;
import org.junit.jupiter.api.Test;

class CallTrustVerifierTest {

  private static void verify(Object proxy) throws Exception {
    Security.verifyObjectTrust(proxy, CallTrustVerifierTest.class.getClassLoader(), List.of());
  }

  private static Service proxy(Endpoint endpoint) {
    return DeadlineContract.proxy(endpoint, 2000);
  }

  @Test
  void riverTrustsAProxyOfThisTransportWithADeadline() {
    assertThatCode(() -> verify(proxy(Endpoints.tcpClient("127.0.0.1", 4160))))
        .doesNotThrowAnyException();
  }

  @Test
  void riverDoesNotTrustAnEndpointThatItDoesNotKnow() {
    Endpoint strange =
        new Endpoint() {
          @Override
          public OutboundRequestIterator newRequest(InvocationConstraints constraints) {
            throw new AssertionError("it is only verified");
          }
        };
    assertThatExceptionOfType(SecurityException.class).isThrownBy(() -> verify(proxy(strange)));
  }

  @Test
  void riverDoesNotTrustAHandlerThatItDoesNotKnow() {
    InvocationHandler handler = (proxy, method, args) -> null;
    Object strange =
        Proxy.newProxyInstance(
            Service.class.getClassLoader(),
            new Class<?>[] {Service.class, RemoteMethodControl.class},
            handler);
    assertThatExceptionOfType(SecurityException.class).isThrownBy(() -> verify(strange));
  }
}

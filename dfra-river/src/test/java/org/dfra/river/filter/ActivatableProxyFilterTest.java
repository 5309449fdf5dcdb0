package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.util.List;
import org.dfra.river.fixture.ChildJvm;
import org.junit.jupiter.api.Test;

/** The proxies that {@code java.rmi.activation.Activatable} makes, where streams are filtered. */
class ActivatableProxyFilterTest {

  /** What the proxy offers. */
  public interface Bell extends Remote {
    String ring() throws RemoteException;
  }

  abstract static class BellImpl implements Bell {}

  @Test
  void theHandlerOfActivatableObjectsIsAllowed() throws Exception {
    AllowedTypes types = AllowedTypes.parse("");
    types.check(Class.forName("java.rmi.activation.ActivatableHandler"));
    types.check(Class.forName("java.rmi.server.RemoteObjectInvocationHandler"));
    assertThatThrownBy(
            () -> types.check(Class.forName("sun.reflect.annotation.AnnotationInvocationHandler")))
        .isInstanceOf(RefusedDataException.class);
  }

  @Test
  void anActivatableProxyIsReadInAFilteredVirtualMachine() throws Exception {
    assertThat(ChildJvm.run(Filtered.class, List.of())).contains("read Activatable[");
  }

  /** Marshals such a proxy and reads it again. */
  static final class Filtered {
    public static void main(String[] args) throws Exception {
      SerialFilters.install();
      Method maker =
          Class.forName("java.rmi.activation.ActivatableHandler")
              .getDeclaredMethod("proxy", ActivationID.class, Class.class, Remote.class);
      maker.setAccessible(true);
      Object proxy = maker.invoke(null, null, BellImpl.class, null);
      InvocationHandler handler = Proxy.getInvocationHandler(new MarshalledObject<>(proxy).get());
      assertThat(handler.getClass().getSimpleName()).isEqualTo("ActivatableHandler");
      System.out.println("read " + new MarshalledObject<>(proxy).get());
    }
  }
}

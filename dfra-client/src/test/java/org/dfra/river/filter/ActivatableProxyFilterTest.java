package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.InvalidClassException;
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

  private static final List<String> OF_JRMP =
      List.of(
          "java.rmi.activation.ActivatableHandler",
          "java.rmi.activation.ActivationGroup_Stub",
          "java.rmi.activation.ActivationID",
          "java.rmi.server.RemoteObject",
          "java.rmi.server.RemoteObjectInvocationHandler");

  @Test
  void referencesOfJrmpAreRefused() throws Exception {
    AllowedTypes types = AllowedTypes.parse("java.rmi.**");
    for (String name : OF_JRMP) {
      Class<?> type = Class.forName(name);
      assertThatThrownBy(() -> types.check(type))
          .isInstanceOf(RefusedDataException.class)
          .hasMessageContaining("refused to read class " + name)
          .hasMessageContaining("set dfra.serial.jrmp=true where it is read");
    }
  }

  @Test
  void referencesOfJrmpAreAllowedWhereTheyAreConfigured() throws Exception {
    AllowedTypes types = AllowedTypes.parse("", true);
    for (String name : OF_JRMP) {
      types.check(Class.forName(name));
    }
    assertThatThrownBy(() -> types.check(java.rmi.server.UnicastRemoteObject.class))
        .isInstanceOf(RefusedDataException.class);
    assertThatThrownBy(
            () -> types.check(Class.forName("sun.reflect.annotation.AnnotationInvocationHandler")))
        .isInstanceOf(RefusedDataException.class);
  }

  @Test
  void anActivatableProxyIsReadInAFilteredVirtualMachine() throws Exception {
    assertThat(ChildJvm.run(Filtered.class, List.of("-Ddfra.serial.jrmp=true")))
        .contains("read Activatable[");
    assertThat(ChildJvm.run(Filtered.class, List.of()))
        .contains("refused to read class java.rmi.activation.ActivatableHandler");
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
      MarshalledObject<Object> marshalled = new MarshalledObject<>(proxy);
      InvocationHandler handler;
      try {
        handler = Proxy.getInvocationHandler(marshalled.get());
      } catch (InvalidClassException e) {
        System.out.println(e.getCause().getMessage());
        return;
      }
      assertThat(handler.getClass().getSimpleName()).isEqualTo("ActivatableHandler");
      System.out.println("read " + new MarshalledObject<>(proxy).get());
    }
  }
}

package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.ServerException;
import java.rmi.activation.UnknownObjectException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.ModuleActivation;
import org.junit.jupiter.api.Test;

/** A module is forgotten only when it has ended; phoenix and the module are played here. */
class ModuleTerminatorTest {

  private static final Duration LONG = Duration.ofSeconds(60);

  private static final RegisteredGroup.RegisteredModule DRIVE =
      new RegisteredGroup.RegisteredModule(
          null,
          null,
          "wheels",
          new ModuleActivation(
              new ModuleDescription(
                  "r",
                  "drive",
                  "a.Server",
                  "a.Proxy",
                  "a.Driver",
                  null,
                  true,
                  Parameters.of("r/drive", Map.of()),
                  SourceLocation.CODE),
              new UUID(1, 2),
              "127.0.0.1",
              List.of(),
              List.of()));

  private static final List<String> CALLS = new ArrayList<>();

  /** What happens at a call: an answer, or a throwable. */
  private static Iterator<Object> script(Object... events) {
    return Arrays.asList(events).iterator();
  }

  private static Iterator<Object> proxies = script();
  private static Iterator<Object> endings = script();
  private static Iterator<Object> unregistrations = script();

  ModuleTerminatorTest() {
    CALLS.clear();
  }

  private static Object next(String call, Iterator<Object> events) throws Throwable {
    CALLS.add(call);
    Object event = events.next();
    if (event instanceof Throwable thrown) {
      throw thrown;
    }
    return event == NOTHING ? null : event;
  }

  private static final Object NOTHING = new Object();

  /** The module's server, which can be marshalled. */
  private record Server() implements java.lang.reflect.InvocationHandler, java.io.Serializable {
    @Override
    public Object invoke(Object proxy, java.lang.reflect.Method method, Object[] arguments)
        throws Throwable {
      return switch (method.getName()) {
        case "getAdmin" -> proxy(ModuleAdmin.class);
        case "deactivate" -> next("deactivate", endings);
        default -> throw new AssertionError(method);
      };
    }
  }

  private static Object proxy(Class<?>... types) {
    return Proxy.newProxyInstance(ModuleTerminatorTest.class.getClassLoader(), types, new Server());
  }

  private static MarshalledObject<Remote> running() throws Exception {
    return new MarshalledObject<>((Remote) proxy(RemoteModule.class));
  }

  private static PhoenixAdmin phoenix() {
    return (PhoenixAdmin)
        Proxy.newProxyInstance(
            ModuleTerminatorTest.class.getClassLoader(),
            new Class<?>[] {PhoenixAdmin.class},
            (proxy, method, arguments) ->
                switch (method.getName()) {
                  case "activeProxy" -> next("activeProxy", proxies);
                  case "unregisterInactive" -> next("unregister", unregistrations);
                  default -> throw new InvocationTargetException(null, method.getName());
                });
  }

  @Test
  void aModuleThatRunsIsEndedBeforeItIsForgotten() throws Exception {
    proxies = script(running());
    endings = script(NOTHING);
    unregistrations = script(true);
    new ModuleTerminator(phoenix(), LONG).forget(DRIVE);
    assertThat(CALLS).containsExactly("activeProxy", "deactivate", "unregister");
  }

  @Test
  void oneThatDoesNotRunIsNotStartedForIt() throws Exception {
    proxies = script(NOTHING);
    unregistrations = script(true);
    new ModuleTerminator(phoenix(), LONG).forget(DRIVE);
    assertThat(CALLS).containsExactly("activeProxy", "unregister");
  }

  @Test
  void oneThatIsStartedMeanwhileIsEndedAgain() throws Exception {
    proxies = script(running(), running());
    endings = script(NOTHING, NOTHING);
    unregistrations = script(false, true);
    new ModuleTerminator(phoenix(), LONG).forget(DRIVE);
    assertThat(CALLS)
        .containsExactly(
            "activeProxy", "deactivate", "unregister", "activeProxy", "deactivate", "unregister");
  }

  @Test
  void answersThatAreLostAreAskedForAgain() throws Exception {
    proxies = script(new ConnectException("busy"), running(), NOTHING);
    endings = script(new ConnectException("its machine ended with it"));
    unregistrations = script(new ConnectException("busy"), new UnknownObjectException("it did"));
    new ModuleTerminator(phoenix(), LONG).forget(DRIVE);
    assertThat(CALLS).endsWith("unregister", "unregister");
  }

  @Test
  void oneThatDoesNotAnswerStaysRegisteredAndThatIsSaid() throws Exception {
    proxies = script(running());
    endings = script(new RemoteException("got no answer within 10000 ms; it may have run"));
    assertThatThrownBy(() -> new ModuleTerminator(phoenix(), Duration.ZERO).forget(DRIVE))
        .isInstanceOf(NotEndedException.class)
        .hasMessage(
            "r/drive may still work in group wheels: got no answer within 10000 ms; it may have"
                + " run; end its process with ./dfra module kill r/drive and try again");
    assertThat(CALLS).doesNotContain("unregister");
  }

  @Test
  void oneWhoseDriverDidNotCloseIsNotTakenForEnded() throws Exception {
    proxies = script(running());
    endings =
        script(
            new ServerException(
                "RemoteException in server thread",
                new RemoteException("its driver did not close: the port hangs")));
    assertThatThrownBy(() -> new ModuleTerminator(phoenix(), LONG).forget(DRIVE))
        .isInstanceOf(NotEndedException.class)
        .hasMessageContaining("group wheels: its driver did not close: the port hangs; end its");
    assertThat(CALLS).doesNotContain("unregister");
  }
}

package org.dfra.attack.fuzz;

import java.io.IOException;
import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.rmi.Remote;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import net.jini.core.entry.Entry;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.lookup.entry.Name;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.module.LogLevel;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.call.Endpoints;
import org.dfra.river.phoenix.stop.StopLocator;
import org.dfra.river.phoenix.stop.StopService;
import org.dfra.river.remote.RemoteModuleListener;

/**
 * A remote object that is sent changed calls.
 *
 * @param name what it is, for messages
 * @param object where it is exported
 * @param calls valid calls of its methods
 */
record FuzzTarget(String name, ObjectEndpoint object, List<byte[]> calls) {

  private static final String REGGIE = "com.sun.jini.reggie.";
  private static final long LEASE_MILLIS = 2_000;
  private static final ServiceID ID = new ServiceID(4711, 4711);

  /** A module of a robot. */
  static FuzzTarget module(RemoteThermometer module, RemoteModuleListener listener)
      throws Exception {
    Class<?> type = RemoteThermometer.class;
    Class<Duration> duration = Duration.class;
    return new FuzzTarget(
        "a module",
        RawCall.endpoint(module),
        List.of(
            CallBytes.of(type.getMethod("celsius")),
            CallBytes.of(type.getMethod("readiness")),
            CallBytes.of(type.getMethod("history")),
            CallBytes.of(type.getMethod("parameters")),
            CallBytes.of(type.getMethod("awaitReadiness", duration), Duration.ofMillis(1)),
            CallBytes.of(type.getMethod("acquireLease", duration), Duration.ofMillis(100)),
            CallBytes.of(type.getMethod("setLogLevel", LogLevel.class), LogLevel.INFO),
            CallBytes.of(
                type.getMethod("setParameter", String.class, String.class), "celsius", "21"),
            CallBytes.of(
                type.getMethod("subscribe", ModuleListener.class, DeliveryPolicy.class),
                listener,
                DeliveryPolicy.keepLast(10))));
  }

  /** Reggie behind DFRA's dispatcher; its proxy calls from the attacker's address. */
  static FuzzTarget registrar(ServiceRegistrar registrar, RemoteEventListener listener)
      throws Exception {
    Remote server = SourceBoundProxies.remote(registrar, Remote.class);
    Object byName = template(new ServiceTemplate(null, null, new Entry[] {new Name("fuzz")}));
    Object byType =
        template(new ServiceTemplate(null, new Class<?>[] {ServiceRegistrar.class}, null));
    Object item =
        make(
            "Item", ServiceItem.class, new ServiceItem(ID, "fuzz", new Entry[] {new Name("fuzz")}));
    Object entries = Array.newInstance(Class.forName(REGGIE + "EntryRep"), 1);
    Array.set(entries, 0, make("EntryRep", Entry.class, new Name("more")));
    Uuid lease = UuidFactory.create(1, 2);
    return new FuzzTarget(
        "a registrar",
        RawCall.endpoint(server),
        List.of(
            call(server, "register", item, LEASE_MILLIS),
            call(server, "lookup", byName),
            call(server, "lookup", byType, 10),
            call(
                server,
                "notify",
                byName,
                ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
                listener,
                null,
                LEASE_MILLIS),
            call(server, "getEntryClasses", byType),
            call(server, "getFieldValues", byName, 0, 0),
            call(server, "getServiceTypes", byType, "net."),
            call(server, "addAttributes", ID, lease, entries),
            call(server, "setAttributes", ID, lease, entries),
            call(server, "renewServiceLease", ID, lease, LEASE_MILLIS),
            call(server, "renewLeases", new Object[] {ID}, new Uuid[] {lease}, new long[] {1}),
            call(server, "cancelLeases", new Object[] {ID}, new Uuid[] {lease}),
            call(server, "getMemberGroups"),
            call(server, "setMemberGroups", (Object) new String[] {"fuzz"})));
  }

  /** The stop service of a phoenix that runs no effector. */
  static FuzzTarget stopService(PhoenixProcess phoenix) throws Exception {
    Method stop = StopService.class.getMethod("emergencyStop", List.class, String.class);
    return new FuzzTarget(
        "phoenix's stop service",
        new BasicObjectEndpoint(
            Endpoints.tcpClient(phoenix.host(), phoenix.port()), StopLocator.IDENTITY, false),
        List.of(
            CallBytes.of(stop, List.of(), "an operator"),
            CallBytes.of(stop, List.of("eta", "theta"), "an operator"),
            CallBytes.of(stop, List.of("eta"), null)));
  }

  private static Object template(ServiceTemplate template) throws Exception {
    return make("Template", ServiceTemplate.class, template);
  }

  /** Reggie's own classes are not public. */
  private static Object make(String name, Class<?> from, Object argument)
      throws ReflectiveOperationException {
    Constructor<?> constructor = Class.forName(REGGIE + name).getDeclaredConstructor(from);
    constructor.setAccessible(true);
    return constructor.newInstance(argument);
  }

  private static byte[] call(Remote server, String name, Object... arguments) throws IOException {
    Method method =
        Arrays.stream(server.getClass().getInterfaces())
            .flatMap(type -> Arrays.stream(type.getMethods()))
            .filter(each -> each.getName().equals(name))
            .filter(each -> each.getParameterCount() == arguments.length)
            .findAny()
            .orElseThrow(() -> new IOException("the registrar has no method " + name));
    return CallBytes.of(method, arguments);
  }

  /** Sends a call. The server may refuse it before it has all of it. */
  Status send(byte[] bytes, Duration patience) throws Exception {
    try (RawCall call = RawCall.to(object)) {
      try {
        return call.send(bytes).finish(patience).status();
      } catch (IOException e) {
        return Status.ABORTED;
      }
    }
  }
}

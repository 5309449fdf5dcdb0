package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;

/** Which code is loaded, and as which classes. */
class VerifiedClassProviderTest extends ServedJarFixture {

  @Test
  void loadsAPinnedJar() throws Exception {
    String codebase = serve();
    Class<?> loaded = load(pinning(codebase), codebase);
    assertThat(loaded.getName()).isEqualTo(KIND);
    assertThat(System.getProperty(RAN)).as("loading does not initialise").isNull();
    loaded.getConstructor().newInstance();
    assertThat(System.getProperty(RAN)).isEqualTo("yes");
    assertThat(new String(loaded.getResourceAsStream("name.txt").readAllBytes()))
        .isEqualTo("lidar");
  }

  @Test
  void loadsAJarSignedByATrustedKey() throws Exception {
    team.sign(jar);
    String codebase = serve();
    Class<?> loaded = load(trusting(team), codebase);
    assertThat(loaded.getProtectionDomain().getCodeSource().getCodeSigners()).hasSize(1);
  }

  @Test
  void loadsNothingFromEntriesThatNobodyNeedsToSign() throws Exception {
    team.sign(jar);
    add("META-INF/SIG-evil.class");
    String codebase = serve();
    assertThatThrownBy(() -> trusting(team).loadClass(codebase, "META-INF.SIG-evil", null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("nor in codebase");
  }

  @Test
  void equalAnnotationsGiveTheSameClassAndItTravelsOnUnderIts() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    Class<?> loaded = load(provider, codebase);
    server.close(); // what is loaded needs no server any more
    assertThat(load(provider, codebase)).isSameAs(loaded);
    assertThat(provider.getClassLoader(codebase)).isSameAs(loaded.getClassLoader());
    assertThat(provider.getClassAnnotation(loaded)).isEqualTo(codebase);
    assertThat(provider.loadClass(codebase, "[L" + KIND + ";", null).getComponentType())
        .isSameAs(loaded);
    assertThat(provider.getClassAnnotation(loaded.arrayType())).isEqualTo(codebase);
    assertThat(provider.getClassAnnotation(String.class)).isNull();
  }

  @Test
  void namesWithoutAClassLeaveNothingInALoader() throws Exception {
    List<String> asked = new ArrayList<>();
    ClassLoader recording =
        new ClassLoader(getClass().getClassLoader()) {
          @Override
          protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            asked.add(name); // of which the JDK keeps an entry for ever
            return super.loadClass(name, resolve);
          }
        };
    VerifiedClassProvider provider = new VerifiedClassProvider(CodeTrust.NONE);
    String[] interfaces = {"java.lang.Runnable", "no.such.Interface"};
    assertThatThrownBy(() -> provider.loadClass(null, "no.such.Sensor", recording))
        .isInstanceOf(ClassNotFoundException.class);
    assertThatThrownBy(() -> provider.loadProxyClass(null, interfaces, recording))
        .isInstanceOf(ClassNotFoundException.class);
    assertThat(asked).containsOnly("java.lang.Runnable");
    assertThat(provider.loadProxyClass(null, new String[] {"java.lang.Runnable"}, recording))
        .matches(Proxy::isProxyClass);
  }

  @Test
  void manyThreadsGetOneClass() throws Exception {
    team.sign(jar);
    String codebase = serve();
    VerifiedClassProvider provider = trusting(team);
    ExecutorService threads = Executors.newFixedThreadPool(16);
    try {
      List<Future<Class<?>>> loading = new ArrayList<>();
      for (int i = 0; i < 64; i++) {
        loading.add(threads.submit(() -> load(provider, codebase)));
      }
      for (Future<Class<?>> each : loading) {
        assertThat(each.get()).isSameAs(loading.get(0).get());
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void theClassPathGoesFirst() throws Exception {
    VerifiedClassProvider provider = new VerifiedClassProvider(CodeTrust.NONE);
    assertThat(provider.loadClass("http://nowhere/", CodeTrust.class.getName(), null))
        .isSameAs(CodeTrust.class);
    assertThatThrownBy(() -> provider.loadClass(null, KIND, null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("no codebase came with it");
    assertThatThrownBy(() -> provider.loadClass("http://nowhere/", "int", null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasNoCause();
  }

  @Test
  void loadsProxiesOfDownloadedInterfaces() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    String[] interfaces = {
      "sample.lidar.RemoteLidar", "net.jini.core.constraint.RemoteMethodControl"
    };
    Class<?> proxy = provider.loadProxyClass(codebase, interfaces, null);
    assertThat(Proxy.isProxyClass(proxy)).isTrue();
    assertThat(provider.getClassAnnotation(proxy)).isEqualTo(codebase);
    assertThat(provider.loadProxyClass(codebase, new String[] {"sample.lidar.Hidden"}, null))
        .isNotNull();
    String[] local = {"java.lang.Runnable"};
    assertThat(Proxy.isProxyClass(provider.loadProxyClass(codebase, local, null))).isTrue();
    assertThatThrownBy(() -> provider.loadProxyClass("http://nowhere/", interfaces, null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("http: is not accepted");
  }
}

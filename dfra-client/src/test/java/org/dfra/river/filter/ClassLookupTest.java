package org.dfra.river.filter;

import static java.io.File.pathSeparator;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.management.ManagementFactory;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.management.ObjectName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Classes are found as the JDK finds them, and invented names leave nothing in the loader. */
class ClassLookupTest {

  /** Records the names of which it is asked for a class: for each the JDK keeps a lock for ever. */
  private static final class RecordingLoader extends ClassLoader {

    private final List<String> asked = new ArrayList<>();

    RecordingLoader() {
      super(ClassLookupTest.class.getClassLoader());
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      asked.add(name);
      return super.loadClass(name, resolve);
    }
  }

  private static final int INVENTED = 4000;

  private final RecordingLoader loader = new RecordingLoader();

  @Test
  void asksALoaderOnceForEachClass() throws Exception {
    String name = ClassLookupTest.class.getName();
    Class<?> first = ClassLookup.find(name, loader);
    assertThat(ClassLookup.find(name, loader)).isSameAs(first).isSameAs(ClassLookupTest.class);
    assertThat(ClassLookup.exists(name, loader)).isTrue();
    assertThat(loader.asked).containsExactly(name);
    RecordingLoader other = new RecordingLoader();
    assertThat(ClassLookup.find(name, other)).isSameAs(first);
    assertThat(other.asked).as("another loader may have another class").containsExactly(name);
  }

  /** The classes are of the loader itself, so they would keep it if they were kept. */
  @Test
  void keepsNoLoader() throws Exception {
    URL[] classes = {
      ClassLookupTest.class.getProtectionDomain().getCodeSource().getLocation(),
    };
    URLClassLoader own = new URLClassLoader(classes, ClassLoader.getPlatformClassLoader());
    Class<?> found = ClassLookup.find(Standalone.class.getName(), own);
    assertThat(found.getClassLoader()).isSameAs(own);
    java.lang.ref.WeakReference<ClassLoader> watched = new java.lang.ref.WeakReference<>(own);
    own.close();
    found = null;
    own = null;
    org.awaitility.Awaitility.await()
        .atMost(java.time.Duration.ofSeconds(30))
        .until(
            () -> {
              System.gc();
              return watched.get() == null;
            });
  }

  /** Needs no other class of the tests. */
  public static final class Standalone {}

  @ParameterizedTest
  @ValueSource(
      strings = {
        "no.such.Sensor",
        "[Lno.such.Sensor;",
        "[[[Lno.such.Sensor;",
        "java/lang/String",
        "java.lang.String;",
        "[java.lang.String",
        "[Ljava.lang.String",
        "[Q",
        "[",
        "",
        "int",
        "../../etc/passwd",
      })
  void aNameWithoutAClassDoesNotReachTheLoader(String name) {
    assertThatThrownBy(() -> ClassLookup.find(name, loader))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessage(name);
    assertThat(loader.asked).isEmpty();
  }

  @Test
  void aClassIsFoundLikeByTheJdk() throws Exception {
    for (Class<?> each :
        List.of(
            String.class,
            String[][].class,
            int[].class,
            boolean[][].class,
            ClassLookupTest.class,
            RecordingLoader[].class,
            org.dfra.flow.sensor.GPSSensor.class)) {
      assertThat(ClassLookup.find(each.getName(), loader)).isSameAs(each);
      assertThat(ClassLookup.find(each.getName(), loader)).as("again").isSameAs(each);
      assertThat(ClassLookup.exists(each.getName(), loader)).isTrue();
    }
    assertThat(ClassLookup.find("java.lang.String", null)).isSameAs(String.class);
  }

  @Test
  void aNameHasNotTooManyCharacters() {
    assertThat(ClassLookup.exists("x".repeat(ClassLookup.MAX_CHARACTERS + 1), null)).isFalse();
  }

  @Test
  void anArrayHasFewDimensions() throws Exception {
    String most = "[".repeat(ClassLookup.MAX_DIMENSIONS) + "I";
    assertThat(ClassLookup.find(most, loader).isArray()).isTrue();
    assertThatThrownBy(() -> ClassLookup.find("[" + most, loader))
        .isInstanceOf(ClassNotFoundException.class);
  }

  /** The JDK's own loaders remember a file that they do not have: see {@link ClassFiles}. */
  @Test
  void inventedNamesLeaveNothingInTheLoadersOfTheJdk() throws Exception {
    ClassLoader application = ClassLoader.getSystemClassLoader();
    for (int i = 0; i < ClassLookup.MAX_MISSES; i++) {
      assertThat(ClassLookup.exists("no.such.Name" + i, application)).isFalse();
    }
    long before = entriesOfConcurrentMaps();
    for (int i = 0; i < INVENTED; i++) {
      assertThat(ClassLookup.exists("no.such.Other" + i, application)).isFalse();
      assertThat(ClassLookup.exists("java.lang.Other" + i, application)).isFalse();
    }
    assertThat(entriesOfConcurrentMaps() - before).isLessThan(INVENTED / 2);
    aClassIsFoundLikeByTheJdk();
    assertThat(ClassLookup.exists("java.rmi.activation.ActivationID", application))
        .isEqualTo(application.getResource("java/rmi/activation/ActivationID.class") != null);
  }

  /** Of a class path that ends with an empty entry, which is the current folder. */
  @Test
  void aFileIsFoundByTheLoaderThatHasItAndByItsChildren() throws Exception {
    ClassFiles files = new ClassFiles(System.getProperty("java.class.path") + pathSeparator, null);
    assertThat(files.has("pom.xml", ClassLoader.getSystemClassLoader()))
        .as("here, as in the module's folder")
        .isEqualTo(Files.exists(Path.of("pom.xml")));
    String name = "org/dfra/river/filter/ClassLookupTest.class";
    URL folder = ClassLookupTest.class.getProtectionDomain().getCodeSource().getLocation();
    try (URLClassLoader has = new URLClassLoader(new URL[] {folder}, null);
        URLClassLoader child = new URLClassLoader(new URL[0], has);
        URLClassLoader hasNot = new URLClassLoader(new URL[0], null)) {
      assertThat(files.has(name, has)).isTrue();
      assertThat(files.has(name, child)).isTrue();
      assertThat(files.has(name, hasNot)).isFalse();
      assertThat(files.has("java/lang/String.class", hasNot)).isTrue();
      assertThat(files.has("java/lang/Strong.class", hasNot)).isFalse();
    }
    assertThat(files.has(name, loader)).as("another kind of loader").isTrue();
    assertThat(files.has(name, new Downloaded(name))).isTrue();
    assertThat(files.has("no/such/Sensor.class", new Downloaded(name))).isFalse();
    assertThat(files.has("java/lang/String.class", new Downloaded(name))).isTrue();
  }

  /** A loader of downloaded code, with one file. */
  private static final class Downloaded extends ClassLoader implements TrustedLoader {

    private final String file;

    Downloaded(String file) {
      super(ClassLoader.getSystemClassLoader());
      this.file = file;
    }

    @Override
    public boolean hasFile(String asked) {
      return asked.equals(file);
    }

    @Override
    public URL getResource(String asked) {
      throw new AssertionError(asked + " reaches the loaders of the JDK");
    }
  }

  private static long entriesOfConcurrentMaps() throws Exception {
    String histogram =
        (String)
            ManagementFactory.getPlatformMBeanServer()
                .invoke(
                    new ObjectName("com.sun.management:type=DiagnosticCommand"),
                    "gcClassHistogram",
                    new Object[] {new String[0]},
                    new String[] {String[].class.getName()});
    return histogram
        .lines()
        .filter(line -> line.contains("java.util.concurrent.ConcurrentHashMap$Node "))
        .mapToLong(line -> Long.parseLong(line.strip().split("\\s+")[1]))
        .sum();
  }
}

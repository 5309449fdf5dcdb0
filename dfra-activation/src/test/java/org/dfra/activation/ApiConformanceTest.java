package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationID;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The module's API is that of Java SE 16, as every later JDK's ct.sym still records it. */
class ApiConformanceTest {

  private static final String PROBE =
      """
      import java.rmi.*;
      import java.rmi.activation.*;
      import java.util.Properties;
      abstract class Probe extends ActivationGroup {
        Probe(ActivationGroupID id, MarshalledObject<?> data) throws RemoteException { super(id); }
        static Remote use(ActivationSystem system, Activator activator) throws Exception {
          String[] options = {"-Xmx64m"};
          var command = new ActivationGroupDesc.CommandEnvironment(null, options);
          var group = new ActivationGroupDesc("Probe", null, null, new Properties(), command);
          ActivationGroupID groupId = system.registerGroup(group);
          var desc = new ActivationDesc(groupId, "Impl", "file:x.jar", null, true);
          ActivationID id = system.registerObject(desc);
          ActivationGroup.createGroup(groupId, group, ActivationSystem.SYSTEM_PORT);
          Activatable.inactive(id);
          MarshalledObject<? extends Remote> proxy = activator.activate(id, true);
          return proxy == null ? id.activate(false) : proxy.get();
        }
        static Throwable why(ActivationException e) { return e.detail; }
        void sleep() throws RemoteException, UnknownGroupException { inactiveGroup(); }
      }
      """;

  @TempDir private Path folder;

  @Test
  void testsSeeTheClassesOfTheBootLoader() {
    assertThat(ActivationID.class.getClassLoader()).isNull();
    assertThat(ActivationID.class.getModule().isNamed()).isFalse();
  }

  @Test
  void everyClassHasThePublicAndProtectedMembersOfRelease16() throws IOException {
    Map<String, Path> wanted = ApiListing.ofRelease16(folder);
    Map<String, Path> found = ApiListing.ofThisModule();

    assertThat(wanted).hasSize(16);
    assertThat(found.keySet()).containsAll(wanted.keySet());
    Map<String, Object> differences = new TreeMap<>();
    wanted.forEach(
        (name, file) -> {
          var difference = ApiListing.difference(file, found.get(name));
          if (!difference.isEmpty()) {
            differences.put(name, difference);
          }
        });
    assertThat(differences).as("release 16 (-) against this module (+)").isEmpty();
  }

  @Test
  void noFurtherClassIsPublic() throws IOException {
    Map<String, Path> wanted = ApiListing.ofRelease16(folder);
    Map<String, Path> found = ApiListing.ofThisModule();
    found.keySet().removeAll(wanted.keySet());

    assertThat(found).isNotEmpty();
    assertThat(found.values()).noneMatch(ApiListing::isPublic);
  }

  @Test
  void nestedClassIsStatic() {
    assertThat(Modifier.isStatic(CommandEnvironment.class.getModifiers())).isTrue();
  }

  @Test
  void oneProbeCompilesToTheSameCodeAgainstBoth() throws IOException {
    String release16 = compileProbe("old", "--release", "16");
    String ours =
        compileProbe("new", "--release", "17", "-cp", System.getProperty("dfra.boot-class-path"));

    assertThat(ours).contains("inactiveGroup").isEqualTo(release16);
  }

  private String compileProbe(String name, String... options) throws IOException {
    Path out = Files.createDirectories(folder.resolve(name));
    Path source = Files.writeString(out.resolve("Probe.java"), PROBE);
    String[] args = new String[options.length + 4];
    System.arraycopy(options, 0, args, 0, options.length);
    args[options.length] = "-nowarn";
    args[options.length + 1] = "-d";
    args[options.length + 2] = out.toString();
    args[options.length + 3] = source.toString();
    ApiListing.run("javac", args);
    return ApiListing.run("javap", "-c", "-p", out.resolve("Probe.class").toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          a method is missing      |
          a throws clause shrank   | public int a() { return 1; }
          a method became final    | public final int a() throws Exception { return 1; }
          a method is less visible | protected int a() throws Exception { return 1; }
          a result type changed    | public long a() throws Exception { return 1; }
          a method was added       | public int a() throws Exception { return 1; } protected void b() {}
          a constant changed       | public static final int C = 2; public int a() throws Exception { return 1; }
          """)
  void comparisonFindsThatSomethingDiffers(String what, String member) throws IOException {
    String wanted = "public int a() throws Exception { return 1; }";
    if (what.startsWith("a constant")) {
      wanted = "public static final int C = 1; " + wanted;
    }
    Path first = compileClass("wanted", wanted);

    assertThat(ApiListing.difference(first, compileClass("same", wanted))).isEmpty();
    assertThat(ApiListing.difference(first, compileClass("found", member == null ? "" : member)))
        .as(what)
        .isNotEmpty();
  }

  private Path compileClass(String name, String member) throws IOException {
    Path out = Files.createDirectories(folder.resolve(name));
    Path source = Files.writeString(out.resolve("C.java"), "public class C { " + member + " }");
    ApiListing.run("javac", "--release", "17", "-d", out.toString(), source.toString());
    return out.resolve("C.class");
  }
}

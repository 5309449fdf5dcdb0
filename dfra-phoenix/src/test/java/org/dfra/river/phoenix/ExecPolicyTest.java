package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.util.List;
import java.util.Properties;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a group descriptor may make the daemon execute. */
class ExecPolicyTest {

  /** The property by which the test's group has a name. */
  private static final String NAME = Phoenix.GROUP_NAME + "=*";

  private static final ExecPolicy STRICT =
      new ExecPolicy(
          false,
          List.of("/opt/*/java"),
          List.of("-Xmx*m"),
          List.of("robot=atrv1", NAME),
          List.of("/opt/lib/a.jar"),
          List.of());

  @TempDir Path folder;

  @Test
  void permitsWhatIsListed() {
    assertPermitted(STRICT, "/opt/jdk/java", "-Xmx64m", "-cp", "/opt/lib/a.jar", "-Drobot=atrv1");
    assertThatCode(() -> STRICT.check(desc("robot", "atrv1"))).doesNotThrowAnyException();
  }

  @Test
  void refusesEachOtherCommandOptionPropertyAndClassPathByNameAndSaysWhereToPermitIt() {
    assertRefused(STRICT, "/opt/java", "command /opt/java of group r.g is", "permittedCommands");
    assertRefused(STRICT, null, "option -Xmx64g of group r.g is", "permittedOptions", "-Xmx64g");
    assertRefused(
        STRICT, null, "property robot=b of group r.g", "permittedProperties", "-Drobot=b");
    assertRefused(
        STRICT, null, "class path /b.jar of group r.g", "permittedClassPaths", "-cp", "/b.jar");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> STRICT.check(desc("robot", "atrv2")))
        .withMessageContaining("property robot=atrv2 of a group without a name is not permitted")
        .withMessageContaining("permittedProperties in phoenix's configuration");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-Xmx64m",
        "-Xms16m",
        "-Xss512k",
        "-XX:+UseSerialGC",
        "-XX:TieredStopAtLevel=1",
        "-ea:org.dfra...",
        "-Ddfra.serial.allow=com.example.*",
        "-Ddfra.time=real",
        "-Ddfra.class-server=192.0.2.10:4161",
        "-Ddfra.class-server.module.0=Lidar",
        "-Dorg.dfra.group=r.g",
        "-Duser.timezone=UTC"
      })
  void defaultPermitsWhatBoundsAndTunes(String option) {
    assertPermitted(ExecPolicy.DEFAULT, ExecPolicy.ownJava(), option);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-javaagent:/tmp/evil.jar",
        "-agentlib:jdwp=transport=dt_socket,server=y,address=*:1",
        "-agentpath:/tmp/evil.so",
        "-Xbootclasspath/a:/tmp/evil.jar",
        "-Xbootclasspath:/tmp/evil.jar",
        "--class-path=/tmp/evil.jar",
        "--module-path=/tmp/evil",
        "-p",
        "--upgrade-module-path=/tmp/evil",
        "--patch-module=java.base=/tmp/evil.jar",
        "--add-exports=java.base/sun.misc=ALL-UNNAMED",
        "-jar",
        "-m",
        "com.example.Evil",
        "@/tmp/options",
        "-cp",
        "-XX:OnError=/tmp/evil",
        "-XX:OnOutOfMemoryError=/tmp/evil",
        "-XX:+ExitOnOutOfMemoryError -XX:OnError=/tmp/evil",
        "-XX:Flags=/tmp/flags",
        "-XX:VMOptionsFile=/tmp/options",
        "-XX:ErrorFile=/tmp/file",
        "-XX:HeapDumpPath=/tmp/file",
        "-XX:SharedArchiveFile=/tmp/evil.jsa",
        "-Xlog:gc:file=/tmp/file",
        "-Djava.class.path=/tmp/evil.jar",
        "-Djava.library.path=/tmp",
        "-Djava.system.class.loader=com.example.Evil",
        "-Djava.security.policy=/tmp/all",
        "-Djava.security.properties=/tmp/all",
        "-Djava.rmi.server.RMIClassLoaderSpi=com.example.Evil",
        "-Djdk.serialFilter=*",
        "-Djdk.module.path=/tmp/evil",
        "-Dsun.boot.library.path=/tmp",
        "-Dcom.sun.management.jmxremote.port=1",
        "-Dlogback.configurationFile=/tmp/evil.xml",
        "-Ddfra.trust=/tmp/everybody",
        "-Ddfra.boot-class-path=/tmp/evil.jar",
        "-Dorg.dfra.phoenix.lock=/tmp/lock",
        "-Dorg.dfra.phoenix.group=x/y"
      })
  void defaultRefusesWhatRunsCodeOrCommandsOrUsesFiles(String option) {
    assertRefused(
        ExecPolicy.DEFAULT, null, " of group r.g is not permitted; leave it out", "", option);
  }

  @Test
  void defaultPermitsPhoenixsOwnJavaClassPathAndOptionsAndNoOther() {
    String own = System.getProperty("java.class.path");
    for (String option : List.of("-cp", "-classpath", "--class-path")) {
      assertPermitted(ExecPolicy.DEFAULT, null, option, own);
      assertRefused(
          ExecPolicy.DEFAULT,
          null,
          "class path",
          "permittedClassPaths",
          option,
          own + ":/tmp/evil");
    }
    List<String> options = ManagementFactory.getRuntimeMXBean().getInputArguments();
    assertPermitted(ExecPolicy.DEFAULT, null, options.toArray(String[]::new));
    assertRefused(
        ExecPolicy.DEFAULT, "/bin/rm", "command /bin/rm of group r.g", "permittedCommands");
  }

  @Test
  void permitsWhatAPrivateFileSaysAndReadsItEachTime() throws Exception {
    Path missing = folder.resolve("missing");
    Path file = folder.resolve("permitted.options");
    ExecPolicy policy =
        new ExecPolicy(
            false, List.of(), List.of(), List.of(NAME), List.of(), List.of(missing, file));
    assertRefused(policy, null, "option -Xlog:all of", "or as a line to " + file, "-Xlog:all");

    Files.writeString(file, "# mine\n\n-Xlog:all\n-cp /a.jar:/b.jar\n-Dmine=1\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    assertPermitted(policy, null, "-Xlog:all", "-cp", "/a.jar:/b.jar", "-Dmine=1");
    assertRefused(policy, null, "class path /a.jar of", "or as a line to", "-cp", "/a.jar");
    assertRefused(policy, null, "option -Xlog:al", "or as a line to", "-Xlog:al");

    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw----"));
    assertRefused(policy, null, "other users may use the file " + file, "chmod 600", "-Xlog:all");
  }

  @Test
  void classPathMayBePermittedByPatternsOfOptions() {
    ExecPolicy any =
        new ExecPolicy(false, List.of(), List.of("*"), List.of(NAME), List.of(), List.of());
    assertPermitted(any, null, "-cp", "/any.jar", "-javaagent:/any.jar", "-Dany=1");
  }

  @Test
  void starInAPatternIsTheOnlySpecialCharacter() {
    ExecPolicy dots =
        new ExecPolicy(false, List.of("/a.b"), List.of(), List.of(NAME), List.of(), List.of());
    assertRefused(dots, "/aXb", "command /aXb", "permittedCommands");
    assertPermitted(dots, "/a.b");
  }

  @Test
  void standardListsCanBeExtendedInAConfiguration() {
    assertThat(StandardExecPermissions.options(new String[] {"-Xlog:*"}))
        .contains("-Xmx*", "-Xlog:*")
        .hasSize(StandardExecPermissions.OPTIONS.size() + 1);
    assertThat(StandardExecPermissions.properties(new String[] {"mine=*"}))
        .contains("dfra.time=*", "mine=*");
  }

  @Test
  void refusesAGroupClassLocationOrDataOfTheCallers() throws Exception {
    ExecPolicy custom = new ExecPolicy(true, List.of(), List.of(), List.of(), List.of(), List.of());
    for (ActivationGroupDesc each :
        List.of(
            new ActivationGroupDesc("a.Group", null, null, null, null),
            new ActivationGroupDesc(null, "file:/x", null, null, null),
            new ActivationGroupDesc(null, null, new MarshalledObject<>("data"), null, null))) {
      assertThatExceptionOfType(ActivationException.class)
          .isThrownBy(() -> ExecPolicy.DEFAULT.check(each))
          .withMessageContaining("customGroups");
      assertThatCode(() -> custom.check(each)).doesNotThrowAnyException();
    }
  }

  private static void assertPermitted(ExecPolicy policy, String command, String... options) {
    assertThatCode(() -> policy.check(desc(command, options))).doesNotThrowAnyException();
  }

  /**
   * @param words what its message has
   * @param where what else it has
   */
  private static void assertRefused(
      ExecPolicy policy, String command, String words, String where, String... options) {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> policy.check(desc(command, options)))
        .withMessageContaining(words)
        .withMessageContaining(where);
  }

  /** The descriptor of group r.g, as the bootstrap makes it. */
  private static ActivationGroupDesc desc(String command, String[] options) {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, "r.g");
    return new ActivationGroupDesc(properties, new CommandEnvironment(command, options));
  }

  /** A descriptor with one property and nothing else. */
  private static ActivationGroupDesc desc(String name, String value) {
    Properties properties = new Properties();
    properties.setProperty(name, value);
    return new ActivationGroupDesc(properties, null);
  }
}

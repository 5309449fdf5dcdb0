package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.core.config.ConfigurationException;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is found of Java, the boot class path, limits and the computer's name. */
class HostChecksTest {

  private static final Set<String> WHOLE =
      Set.of(
          "java.logging",
          "java.management",
          "java.naming",
          "java.rmi",
          "java.xml",
          "jdk.unsupported");

  @TempDir Path folder;

  @Test
  void javaOlderThan17IsAFailure() {
    assertThat(new JavaCheck(11, "11.0.2", "/opt/java", WHOLE).run())
        .containsExactly(
            Finding.fail(
                Subject.JAVA,
                "Java 11.0.2 at /opt/java is older than 17",
                "Install Java 17 or newer, and name its folder in JAVA_HOME."));
    assertThat(new JavaCheck(17, "17.0.15", "/opt/java", WHOLE).run())
        .containsExactly(Finding.ok(Subject.JAVA, "Java 17.0.15 at /opt/java"));
    assertThat(JavaCheck.ofThisProcess().run().get(0).verdict()).isEqualTo(Verdict.OK);
  }

  @Test
  void aJavaThatLacksModulesIsAFailure() {
    Set<String> some = new HashSet<>(WHOLE);
    some.remove("java.rmi");
    assertThat(new JavaCheck(17, "17.0.15", "/opt/java", some).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("Java 17.0.15 at /opt/java lacks java.rmi", Finding::what);
  }

  @Test
  void onlyTheBootLoaderMayDefineActivation() {
    Optional<String> jar = Optional.of("/opt/dfra/lib/boot/dfra-activation.jar");
    assertThat(new BootJarCheck(name -> Object.class, jar).run())
        .containsExactly(
            Finding.ok(
                Subject.BOOT_JAR,
                "java.rmi.activation comes from /opt/dfra/lib/boot/dfra-activation.jar"));
    assertThat(new BootJarCheck(name -> HostChecksTest.class, jar).run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns(
            "java.rmi.activation is on the class path, not on the boot class path", Finding::what);
    assertThat(
            new BootJarCheck(
                    name -> {
                      throw new ClassNotFoundException(name);
                    },
                    jar)
                .run())
        .singleElement()
        .returns(Verdict.FAIL, Finding::verdict)
        .returns("there is no java.rmi.activation", Finding::what);
    assertThat(BootJarCheck.ofThisProcess().run().get(0).verdict()).isEqualTo(Verdict.OK);
  }

  @Test
  void fewFileDescriptorsAreAWarning() throws IOException {
    assertThat(limit("1024").run())
        .singleElement()
        .returns(Verdict.WARN, Finding::verdict)
        .satisfies(finding -> assertThat(finding.remedy()).contains("ulimit -n 4096"));
    assertThat(limit("4096").run())
        .containsExactly(
            Finding.ok(Subject.FILE_DESCRIPTORS, "a process may have 4096 files and sockets open"));
    assertThat(new FileDescriptorCheck(folder.resolve("none")).run())
        .as("the system does not tell")
        .isEmpty();
  }

  private FileDescriptorCheck limit(String most) throws IOException {
    return new FileDescriptorCheck(
        Files.writeString(
            folder.resolve("limits"),
            """
            Limit                     Soft Limit           Hard Limit           Units
            Max processes             15000                15000                processes
            Max open files            %s                 20000                files
            """
                .formatted(most)));
  }

  @Test
  void aNameThatStandsForTheLoopbackIsAWarning() throws Exception {
    InetAddress debian = InetAddress.getByAddress("robot7", new byte[] {127, 0, 1, 1});
    assertThat(new HostCheck(names(debian, "192.0.2.10"), "auto").run())
        .containsExactly(
            Finding.warn(
                Subject.HOST_NAME,
                "robot7 resolves to 127.0.1.1, which no other computer reaches; DFRA uses"
                    + " 192.0.2.10 instead",
                "Never name robot7 as a robot's host, or let /etc/hosts give it 192.0.2.10."),
            Finding.ok(Subject.HOST_ADDRESS, "proxies carry 192.0.2.10"));
  }

  @Test
  void aNameThatStandsForItsAddressIsWell() throws Exception {
    InetAddress good = InetAddress.getByAddress("robot7", new byte[] {(byte) 192, 0, 2, 10});
    assertThat(new HostCheck(names(good, "192.0.2.10"), "auto").run())
        .allSatisfy(finding -> assertThat(finding.verdict()).isEqualTo(Verdict.OK));
  }

  @Test
  void withoutANetworkOnlyTheLoopbackIsLeft() throws Exception {
    InetAddress debian = InetAddress.getByAddress("robot7", new byte[] {127, 0, 1, 1});
    assertThat(new HostCheck(names(debian, "127.0.0.1"), "auto").run())
        .extracting(Finding::subject, Finding::verdict)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple(Subject.HOST_NAME, Verdict.OK),
            org.assertj.core.groups.Tuple.tuple(Subject.HOST_ADDRESS, Verdict.WARN));
  }

  @Test
  void aNameThatStandsForNothingIsAWarning() {
    assertThat(new HostCheck(names(null, "192.0.2.10"), "auto").run().get(0))
        .returns(Verdict.WARN, Finding::verdict)
        .returns("this computer's own name resolves to no address", Finding::what);
  }

  @Test
  void anAddressThatIsNotThisComputersIsAFailure() {
    HostCheck.HostResolver names =
        new HostCheck.HostResolver() {
          @Override
          public InetAddress ownName() {
            return InetAddress.getLoopbackAddress();
          }

          @Override
          public String advertisedAddress(String wanted) {
            throw new ConfigurationException(
                "host "
                    + wanted
                    + " is not an address of this machine; name one of its addresses, or auto");
          }
        };
    assertThat(new HostCheck(names, "10.9.9.9").run())
        .containsExactly(
            Finding.fail(
                Subject.HOST_ADDRESS,
                "host 10.9.9.9 is not an address of this machine",
                "Name one of its addresses, or auto."));
  }

  private static HostCheck.HostResolver names(@Nullable InetAddress own, String chosen) {
    return new HostCheck.HostResolver() {
      @Override
      public InetAddress ownName() throws UnknownHostException {
        if (own == null) {
          throw new UnknownHostException("robot7");
        }
        return own;
      }

      @Override
      public String advertisedAddress(String wanted) {
        return chosen;
      }
    };
  }
}

package org.dfra.river.identity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.security.auth.kerberos.KerberosPrincipal;
import javax.security.auth.kerberos.KerberosTicket;
import org.dfra.river.fixture.TestTeam;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A login with a ticket of Kerberos beside the key store. It needs MIT Kerberos ({@code krb5-kdc},
 * {@code krb5-admin-server} and {@code krb5-user} of Debian), of which it starts a server of its
 * own, and is skipped without.
 */
@Timeout(60)
class KerberosLoginTest {

  private static final List<String> FOLDERS = List.of("/usr/sbin", "/usr/bin", "/sbin", "/bin");
  private static final String CONFIGURATION = "java.security.krb5.conf";
  private static final String REALM = "FIELD.TEST";
  private static final String HOST = "127.0.0.1";
  private static final TestTeam TEAM = new TestTeam("field");
  private static final Member ANNA = new Member("field", MemberRole.OPERATOR, "anna");

  @TempDir static Path realm;
  @TempDir Path temp;

  private static @Nullable Process server;
  private static @Nullable String former;

  private Path folder;

  private static String tool(String name) {
    return FOLDERS.stream()
        .map(each -> each + "/" + name)
        .filter(each -> Files.isExecutable(Path.of(each)))
        .findFirst()
        .orElse("");
  }

  @BeforeAll
  static void startServer() throws Exception {
    boolean isInstalled =
        Stream.of("kdb5_util", "kadmin.local", "krb5kdc", "kinit")
            .noneMatch(each -> tool(each).isEmpty());
    assumeTrue(
        isInstalled, "MIT Kerberos is not installed: krb5-kdc, krb5-admin-server, krb5-user");
    int port;
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getByName(HOST))) {
      port = free.getLocalPort();
    }
    write(
        "krb5.conf",
        """
        [libdefaults]
          default_realm = %1$s
          dns_lookup_kdc = false
          dns_lookup_realm = false
          rdns = false
          udp_preference_limit = 1
        [realms]
          %1$s = {
            kdc = %2$s:%3$d
          }
        """
            .formatted(REALM, HOST, port));
    write(
        "kdc.conf",
        """
        [kdcdefaults]
          kdc_ports = ""
          kdc_tcp_listen = %2$s:%3$d
        [realms]
          %1$s = {
            database_name = %4$s/principal
            key_stash_file = %4$s/stash
            acl_file = %4$s/acl
          }
        """
            .formatted(REALM, HOST, port, realm));
    run("kdb5_util", "-r", REALM, "create", "-s", "-P", "of-this-test");
    run("kadmin.local", "-r", REALM, "-q", "addprinc -randkey anna");
    run("kadmin.local", "-r", REALM, "-q", "ktadd -k " + realm.resolve("anna.keytab") + " anna");
    server = start("krb5kdc", "-n", "-r", REALM);
    await()
        .atMost(Duration.ofSeconds(20))
        .ignoreException(java.net.ConnectException.class)
        .until(
            () -> {
              try (Socket connected = new Socket(HOST, port)) {
                return connected.isConnected();
              }
            });
    former = System.setProperty(CONFIGURATION, realm.resolve("krb5.conf").toString());
  }

  private static void write(String name, String text) throws IOException {
    Path unused = Files.writeString(realm.resolve(name), text);
  }

  private static Process start(String... words) throws IOException {
    Stream<String> all = Stream.concat(Stream.of(tool(words[0])), Stream.of(words).skip(1));
    ProcessBuilder builder = new ProcessBuilder(all.toList()).redirectErrorStream(true);
    builder.redirectOutput(realm.resolve(words[0] + ".log").toFile());
    builder.environment().put("KRB5_CONFIG", realm.resolve("krb5.conf").toString());
    builder.environment().put("KRB5_KDC_PROFILE", realm.resolve("kdc.conf").toString());
    return builder.start();
  }

  private static void run(String... words) throws Exception {
    Process process = start(words);
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).as(Files.readString(realm.resolve(words[0] + ".log"))).isZero();
  }

  @AfterAll
  static void endServer() {
    if (server != null) {
      server.destroy();
      if (former == null) {
        System.clearProperty(CONFIGURATION);
      } else {
        System.setProperty(CONFIGURATION, former);
      }
    }
  }

  @BeforeEach
  void join() throws IOException {
    folder = TEAM.writeIdentity(temp.resolve("security"), TEAM.issue(ANNA));
  }

  private void configure(String flag, String options) throws IOException {
    Path unused =
        Files.writeString(
            folder.resolve("jaas.conf"),
            """
            dfra {
              com.sun.security.auth.module.Krb5LoginModule %s doNotPrompt="true" %s;
              com.sun.security.auth.module.KeyStoreLoginModule required
                keyStoreType="PKCS12" keyStoreAlias="identity" keyStoreURL="%s";
            };
            """
                .formatted(flag, options, folder.resolve("identity.p12").toUri()));
  }

  private static String keyTab(String file) {
    return "useKeyTab=\"true\" principal=\"anna\" keyTab=\"%s\"".formatted(realm.resolve(file));
  }

  private void assertTicket() throws IdentityException {
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ANNA);
    assertThat(loaded.subject().getPrincipals(KerberosPrincipal.class))
        .extracting(KerberosPrincipal::getName)
        .containsExactly("anna@" + REALM);
    assertThat(loaded.subject().getPrivateCredentials(KerberosTicket.class)).hasSize(1);
  }

  @Test
  void aKeyTableGivesATicketAndItsPrincipal() throws Exception {
    configure("required", keyTab("anna.keytab"));
    assertTicket();
  }

  @Test
  void soDoesTheTicketCacheThatKinitHasWritten() throws Exception {
    Path cache = realm.resolve("cache");
    run(
        "kinit",
        "-c",
        cache.toString(),
        "-k",
        "-t",
        realm.resolve("anna.keytab").toString(),
        "anna");
    configure("required", "useTicketCache=\"true\" ticketCache=\"%s\"".formatted(cache));
    assertTicket();
  }

  @Test
  void withoutATicketTheFlagDecides() throws Exception {
    configure("required", keyTab("missing.keytab"));
    assertThatThrownBy(() -> IdentityFolder.load(folder))
        .isInstanceOf(IdentityException.class)
        .hasMessageContainingAll("the login that", "describes failed");
    configure("optional", keyTab("missing.keytab"));
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ANNA);
    assertThat(loaded.subject().getPrincipals(KerberosPrincipal.class)).isEmpty();
  }
}

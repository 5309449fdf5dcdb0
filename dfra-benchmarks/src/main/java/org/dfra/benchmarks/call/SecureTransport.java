package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.Base64;
import org.dfra.authority.Authority;
import org.dfra.authority.Authority.IssuedBundle;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.security.SecureProcess;
import org.dfra.security.MemberRole;

/**
 * Another transport between two members of a team that exists for this run: the server is a robot,
 * the client an operator. Each call is decided about by the policy that DFRA brings.
 */
final class SecureTransport implements CallTransport {

  private static final String TEAM = "benchmark";
  private static final Duration VALIDITY = Duration.ofDays(1);

  private final CallTransport transport;

  SecureTransport(CallTransport transport) {
    this.transport = transport;
  }

  @Override
  public void prepare() throws IOException {
    transport.prepare();
  }

  /** Prefixes the client's folder, with its identity. */
  @Override
  public String serve(Path folder) throws IOException {
    Path client = folder.resolve("client");
    Path server = folder.resolve("server");
    Path authority = folder.resolve("authority");
    Authority.create(authority, TEAM, "of-this-run", true, Clock.systemUTC());
    try (Authority opened = Authority.open(authority, () -> "of-this-run", Clock.systemUTC())) {
      join(client, opened.issue(MemberRole.OPERATOR, "client", VALIDITY));
      join(server, opened.issue(MemberRole.ROBOT, "server", VALIDITY));
    }
    install(server);
    byte[] path = client.toAbsolutePath().toString().getBytes(StandardCharsets.UTF_8);
    return Base64.getEncoder().encodeToString(path) + " " + transport.serve(folder);
  }

  private static void join(Path folder, IssuedBundle issued) throws IOException {
    PrivateFiles.makeFolder(folder);
    write(issued, folder, SecurityFiles.IDENTITY);
    write(issued, folder, SecurityFiles.ROBOT);
    write(issued, folder, SecurityFiles.AUTHORITY);
    write(issued, folder, SecurityFiles.REVOKED);
    byte[] passphrase = issued.passphrase().getBytes(StandardCharsets.UTF_8);
    PrivateFiles.write(folder.resolve(SecurityFiles.IDENTITY_PASSPHRASE), passphrase);
    PrivateFiles.write(folder.resolve(SecurityFiles.ROBOT_PASSPHRASE), passphrase);
  }

  private static void write(IssuedBundle issued, Path folder, String name) throws IOException {
    byte[] content = issued.bundle().file(name).orElse(null);
    if (content != null) {
      PrivateFiles.write(folder.resolve(name), content);
    }
  }

  private static void install(Path folder) throws IOException {
    SecureProcess.Installed installed = SecureProcess.install(folder, false);
    if (installed.mode() != SecurityMode.SECURE) {
      throw new IOException("this process is " + installed.mode() + ": " + installed.fault());
    }
  }

  @Override
  public Connection connect(String address) throws IOException {
    String[] parts = address.split(" ", 2);
    install(Path.of(new String(Base64.getDecoder().decode(parts[0]), StandardCharsets.UTF_8)));
    return transport.connect(parts[1]);
  }
}

package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import org.dfra.benchmarks.secure.BenchTeam;
import org.dfra.security.MemberRole;

/**
 * Another transport between two members of a team that exists for this run: the server is a robot,
 * the client an operator. Each call is decided about by the policy that DFRA brings.
 */
final class SecureTransport implements CallTransport {

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
    Path client;
    try (BenchTeam team = BenchTeam.create(folder.resolve("authority"))) {
      client = team.join(folder.resolve("client"), MemberRole.OPERATOR, "client");
      BenchTeam.install(team.join(folder.resolve("server"), MemberRole.ROBOT, "server"));
    }
    byte[] path = client.toAbsolutePath().toString().getBytes(StandardCharsets.UTF_8);
    return Base64.getEncoder().encodeToString(path) + " " + transport.serve(folder);
  }

  @Override
  public Connection connect(String address) throws IOException {
    String[] parts = address.split(" ", 2);
    BenchTeam.install(
        Path.of(new String(Base64.getDecoder().decode(parts[0]), StandardCharsets.UTF_8)));
    return transport.connect(parts[1]);
  }
}

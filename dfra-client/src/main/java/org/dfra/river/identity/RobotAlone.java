package org.dfra.river.identity;

import java.security.cert.X509Certificate;
import org.dfra.river.identity.TeamCredentials.RobotKey;
import org.dfra.security.Member;

/**
 * A robot whose identity in its team cannot be used: what it still has.
 *
 * @param member the robot, by the name in its own certificate
 * @param key for calls between its own processes
 * @param authority of the team, to know its other processes by; the robot's own certificate, which
 *     issues none, if the authority's cannot be read
 */
public record RobotAlone(Member member, RobotKey key, X509Certificate authority) {}

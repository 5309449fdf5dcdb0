/**
 * What is installed on a robot's computer, unpacked elsewhere and run with a Java runtime alone.
 */
package org.dfra.dist;

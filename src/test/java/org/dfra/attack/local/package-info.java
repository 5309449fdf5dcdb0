/** Attacks by another user of the robot's computer. */
package org.dfra.attack.local;
